// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/view/packed_normals.hpp>
#include <crease/parts/view/world_space.hpp>

namespace crease {

/// Normals: an image of world-space normals that face the camera, packed to [0, 1] as n / 2 + 1 / 2. The host
/// sets the rotation to view space: see set_world_to_view.
struct packed_world_normals {
    static constexpr resource inputs[] = {normal_image("packed_world_normals", format::rgba8_unorm)};
    static constexpr const glsl_file* files[] = {&packed_normals_glsl, &unit_normal_glsl, &world_space_glsl};
    static constexpr part description{
        .kind = role::normals,
        .name = "packed_world_normals",
        .summary = "an image holds world-space normals, packed to [0, 1]",
        .source = "",
        .files = files,
        .settings = world_settings,
        .resources = inputs,
    };
};

}
