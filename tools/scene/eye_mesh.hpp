// SPDX-License-Identifier: MIT
#pragma once

#include "scene/scene.hpp"

#include <cstdint>
#include <vector>

namespace crease::tools {

/// How large a scene is from an eye, and in which units 32-bit numbers hold it best. All in world units.
struct eye_scale {
    double unit = 1; ///< a power of two, so that it rounds nothing; brings the farthest corner to 1 or 2
    double nearest = 0, farthest = 0; ///< distance of the box around the scene; greatest coordinate in it

    /// A radius in these units.
    /// @throws scene_error where 32 bits cannot hold what lies within it
    float radius(float in_world) const;
};

/// A mesh as a tracer or a rasteriser takes it, in 32 bits: relative to the eye, so that rounding is of the
/// distance to it and not of the place in the world, and in a unit that gives a scene of any size the same
/// numbers.
struct eye_mesh {
    std::vector<glm::vec3> positions; ///< along the world's axes
    std::vector<std::uint32_t>
        indices;                     ///< three a triangle; each has an area also after rounding, and is seen
    std::vector<material> materials; ///< that triangles are of
    std::vector<std::uint32_t> material_ids; ///< of each triangle, places in `materials`
    std::vector<bool> dynamic;               ///< of each triangle, whether it moves
    eye_scale scale;

    std::size_t triangles() const { return indices.size() / 3; }
    const material& material_of(std::size_t triangle) const { return materials[material_ids[triangle]]; }
};

/// Without the triangles of opacity 0.
/// @throws scene_error where no other is left, or the eye is so far that none keeps an area
eye_mesh seen_from(const glm::dvec3& eye, const mesh& scene);

/// The unit normal of a triangle of corners in 32 bits.
glm::dvec3 normal_of(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

}
