// SPDX-License-Identifier: MIT
#pragma once

#include "scene/scene.hpp"

#include <crease/vulkan.hpp>

#include <glm/mat4x4.hpp>

#include <memory>

namespace crease::tools {

/// What the geometry's vertex shaders are pushed.
struct transforms {
    glm::mat4 view_from_world, clip_from_view;
};

/// A scene on the device, and how a camera draws it.
struct geometry {
    std::shared_ptr<vulkan::mesh> triangles;
    transforms how;
};

/// Positions and face normals of all triangles.
/// @throws vulkan::error
std::shared_ptr<vulkan::mesh> upload_geometry(vulkan::device& device, const mesh& scene);

/// View space to Vulkan's clip space, which points down.
glm::mat4 projection_matrix(const camera& from);

/// The view of a projection.
/// @param projection  of the picture, without the guard band
view_parameters view_of(const glm::mat4& projection, unsigned width, unsigned height, unsigned guard = 0);

}
