// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/view/given_normals.hpp>
#include <crease/parts/view/world_space.hpp>

namespace crease {

/// Normals: an image of world-space normals that face the camera, of any length. The host sets the rotation
/// to view space: see set_world_to_view. One that is zero or not finite counts as facing the eye.
struct world_normals {
    static constexpr resource inputs[] = {normal_image("world_normals", format::rgba16_float)};
    static constexpr const glsl_file* files[] = {&given_normals_glsl, &unit_normal_glsl, &world_space_glsl};
    static constexpr part description{
        .kind = role::normals,
        .name = "world_normals",
        .summary = "an image holds world-space normals",
        .source = "",
        .files = files,
        .settings = world_settings,
        .resources = inputs,
    };
};

}
