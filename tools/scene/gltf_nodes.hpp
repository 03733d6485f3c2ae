// SPDX-License-Identifier: MIT
#pragma once

#include "scene/gltf_json.hpp"

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <vector>

namespace crease::tools {

/// Where the nodes of a glTF file stand, in double precision as map coordinates need.
struct gltf_nodes {
    std::vector<glm::dmat4> to_world; ///< by node
    std::vector<std::size_t> shown;   ///< the nodes of the scene that is shown, each before its children
    std::vector<std::size_t> depth;   ///< by node: how many stand above it
    std::vector<bool> animated;       ///< by node: whether an animation moves it, or its shape
};

/// @param root  the whole JSON
/// @throws scene_error where the nodes do not form trees
gltf_nodes read_gltf_nodes(const gltf_value& root);

/// The transform that scales, then rotates, then moves.
glm::dmat4 transform(const glm::dvec3& translation, const glm::dquat& rotation, const glm::dvec3& scale);

}
