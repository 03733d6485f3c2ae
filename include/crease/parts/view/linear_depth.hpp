// SPDX-License-Identifier: MIT
#pragma once

#include <crease/compose/part.hpp>

namespace crease {

inline constexpr glsl_file linear_depth_glsl{
    "view/linear_depth.glsl",
#include <crease/view/linear_depth.glsl>
};

/// Depth encoding: the depth image holds positive linear view depth.
struct linear_depth {
    static constexpr resource inputs[] = {
        {.name = "depth", .texels = format::r32_float, .size = {.guarded = true}, .content = "linear_depth"}};
    static constexpr const glsl_file* files[] = {&linear_depth_glsl};
    static constexpr part description{
        .kind = role::depth_encoding,
        .name = "linear_depth",
        .summary = "the depth image holds linear view depth",
        .source = "stochastic-depth-ao 2020, 4.4",
        .files = files,
        .resources = inputs,
    };
};

}
