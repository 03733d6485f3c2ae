// SPDX-License-Identifier: MIT
#pragma once

#include "scene/gltf_accessors.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace crease::tools {

/// What a primitive of a glTF mesh is made of. The accessors belong to the `gltf_accessors` that read them.
struct gltf_primitive {
    /// Four joints that move each vertex, and how much.
    struct influence {
        const gltf_accessor *joints, *weights;
    };

    gltf_value source; ///< what it was read from
    const gltf_accessor* positions = nullptr;
    const gltf_accessor* indices = nullptr;      ///< null: the vertices in their order
    std::vector<const gltf_accessor*> targets{}; ///< of morphing; null where one moves no position
    std::vector<influence> influences{};
    std::size_t triangles = 0; ///< 0 for points and lines
    std::size_t mode = 4;

    /// The vertices of a triangle.
    /// @throws scene_error where one does not exist
    std::array<std::size_t, 3> triangle(std::size_t i) const;
};

/// @param of  an element of "primitives"
/// @throws scene_error
gltf_primitive read_gltf_primitive(const gltf_value& of, gltf_accessors& accessors);

}
