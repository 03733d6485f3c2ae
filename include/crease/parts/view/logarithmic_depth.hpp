// SPDX-License-Identifier: MIT
#pragma once

#include <crease/compose/part.hpp>

namespace crease {

inline constexpr glsl_file logarithmic_depth_glsl{
    "view/logarithmic_depth.glsl",
#include <crease/view/logarithmic_depth.glsl>
};

/// Depth encoding: the depth image holds log2(1 + w) / log2(1 + far) of the distance w along the view, as
/// three.js writes it with `logarithmicDepthBuffer` and a perspective camera.
struct logarithmic_depth {
    static constexpr resource inputs[] = {{.name = "depth",
                                           .texels = format::d32_float,
                                           .size = {.guarded = true},
                                           .content = "logarithmic_depth"}};
    static constexpr setting settings[] = {
        {"far", 1000, 1e-3f, 1e15f,
         "distance of the far plane, view-space units, by which depth is divided"}};
    static constexpr const glsl_file* files[] = {&logarithmic_depth_glsl};
    static constexpr part description{
        .kind = role::depth_encoding,
        .name = "logarithmic_depth",
        .summary = "the depth image holds log2(1 + w) / log2(1 + far) of the distance w",
        .source = "",
        .files = files,
        .settings = settings,
        .resources = inputs,
    };
};

}
