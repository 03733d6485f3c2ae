// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/view/normal_image.hpp>

namespace crease {

inline constexpr glsl_file given_normals_glsl{
    "view/given_normals.glsl",
#include <crease/view/given_normals.glsl>
};

/// Normals: an image of view-space normals that face the camera, of any length. The default. One that is zero
/// or not finite counts as facing the eye.
struct given_normals {
    static constexpr resource inputs[] = {normal_image("view_normals", format::rgba16_float)};
    static constexpr const glsl_file* files[] = {&given_normals_glsl, &unit_normal_glsl, &view_space_glsl};
    static constexpr part description{
        .kind = role::normals,
        .name = "given_normals",
        .summary = "an image holds view-space normals",
        .source = "stochastic-depth-ao 2020, 4.4",
        .files = files,
        .resources = inputs,
    };
};

}
