// SPDX-License-Identifier: MIT
#pragma once

#include <crease/compose/part.hpp>

namespace crease {

inline constexpr glsl_file device_depth_glsl{
    "view/device_depth.glsl",
#include <crease/view/device_depth.glsl>
};

/// Depth encoding: the depth image is the depth buffer, in [0, 1]. The default.
struct device_depth {
    static constexpr resource inputs[] = {
        {.name = "depth", .texels = format::d32_float, .size = {.guarded = true}, .content = "device_depth"}};
    static constexpr const glsl_file* files[] = {&device_depth_glsl};
    static constexpr part description{
        .kind = role::depth_encoding,
        .name = "device_depth",
        .summary = "the depth image holds device depth",
        .source = "stochastic-depth-ao 2020, 4.4",
        .files = files,
        .resources = inputs,
    };
};

}
