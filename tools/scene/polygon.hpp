// SPDX-License-Identifier: MIT
#pragma once

#include "scene/scene.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace crease::tools {

/// Adds polygons to a mesh as triangles, by clipping ears in the plane that the polygon is largest in
/// (Meisters, 1975).
class triangulator {
public:
    /// @param to  has the positions; outlives this
    explicit triangulator(mesh& to) : to_(to) {}

    /// @param corners  positions of a polygon, which need not be convex; fewer than three add nothing
    /// @throws scene_error where the mesh becomes too large, or the polygons are too involved
    void add(std::span<const std::uint32_t> corners);

private:
    void count_test();
    void clip_ears(std::span<const std::uint32_t> corners);

    mesh& to_;
    std::size_t tests_ = 0; ///< of corners against ears, of all polygons
};

}
