// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/view/normal_image.hpp>

namespace crease {

inline constexpr glsl_file packed_normals_glsl{
    "view/packed_normals.glsl",
#include <crease/view/packed_normals.glsl>
};

/// Normals: an image of view-space normals that face the camera, packed to [0, 1] as n / 2 + 1 / 2.
struct packed_normals {
    static constexpr resource inputs[] = {normal_image("packed_view_normals", format::rgba8_unorm)};
    static constexpr const glsl_file* files[] = {&packed_normals_glsl, &unit_normal_glsl, &view_space_glsl};
    static constexpr part description{
        .kind = role::normals,
        .name = "packed_normals",
        .summary = "an image holds view-space normals, packed to [0, 1]",
        .source = "",
        .files = files,
        .resources = inputs,
    };
};

}
