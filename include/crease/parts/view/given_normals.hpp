// SPDX-License-Identifier: MIT
#pragma once

#include <crease/compose/part.hpp>

namespace crease {

inline constexpr glsl_file given_normals_glsl{
    "view/given_normals.glsl",
#include <crease/view/given_normals.glsl>
};

/// Normals: an image of view-space normals that face the camera, of any length. The default. One that is zero
/// or not finite counts as facing the eye.
struct given_normals {
    static constexpr resource inputs[] = {
        {.name = "normal", .texels = format::rgba16_float, .size = {.guarded = true}}};
    static constexpr const glsl_file* files[] = {&given_normals_glsl};
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
