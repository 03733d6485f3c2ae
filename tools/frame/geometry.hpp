// SPDX-License-Identifier: MIT
#pragma once

#include "scene/eye_mesh.hpp"

#include <crease/vulkan.hpp>

#include <glm/mat4x4.hpp>

#include <memory>

namespace crease::tools {

/// What the geometry's vertex shaders are pushed; in the units of an `eye_mesh`.
struct transforms {
    glm::mat4 view_from_eye; ///< from the world's axes at the first camera's eye
    glm::mat4 clip_from_view;
};

/// A scene on the device, and how a camera draws it.
struct geometry {
    std::shared_ptr<vulkan::mesh> triangles;             ///< all
    std::shared_ptr<vulkan::mesh> of_static, of_dynamic; ///< the same in two; null where none is dynamic
    transforms how;
    eye_scale scale;
};

/// What the depth buffer holds: reversed, 1 at near and 0 at far; standard, 0 at near and 1 at far; or
/// infinite, 1 at near and 0 at infinity, of perspective cameras alone. As 32-bit numbers are finest at 0,
/// those that end there are equally fine, beside the distance, at every distance of a perspective.
enum class device_depth_kind { reversed, standard, infinite };

constexpr const char* name_of(device_depth_kind kind) {
    constexpr const char* names[] = {"reversed", "standard", "infinite"};
    return names[static_cast<int>(kind)];
}

/// Device depth where there is background.
constexpr float background_of(device_depth_kind kind) {
    return kind == device_depth_kind::standard ? 1.0f : 0.0f;
}

/// Positions, face normals and colours of all triangles.
/// @throws vulkan::error
geometry upload_geometry(vulkan::device& device, const eye_mesh& scene, const transforms& how);

/// View space to Vulkan's clip space, which points down; in the units of the scene.
/// @throws scene_error where near is too small beside the scene, or an orthographic camera is to see to
///         infinity
glm::mat4 projection_matrix(const camera& from, const eye_scale& scene, device_depth_kind depth);

/// The view of a projection.
/// @param projection  of the picture, without the guard band
view_parameters view_of(const glm::mat4& projection, unsigned width, unsigned height, unsigned guard = 0);

}
