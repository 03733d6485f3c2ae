// SPDX-License-Identifier: MIT
#pragma once

#include <crease/compose/part.hpp>

namespace crease {

inline constexpr glsl_file linearised_depth_glsl{
    "view/linearised_depth.glsl",
#include <crease/view/linearised_depth.glsl>
};

inline constexpr glsl_file linearise_glsl{
    "view/linearise.glsl",
#include <crease/view/linearise.glsl>
};

/// Depth encoding: the depth image is the depth buffer, in [0, 1], and a first pass stores the linear view
/// depth of its texels, from which all others load: for effects with many taps.
struct linearised_depth {
    static constexpr resource images[] = {
        {.name = "depth", .texels = format::d32_float, .size = {.guarded = true}, .content = "device_depth"},
        {.name = "linearised_depth",
         .texels = format::r32_float,
         .life = lifetime::transient,
         .size = {.guarded = true},
         .read = access::load}};
    static constexpr const glsl_file* linearising[] = {&linearise_glsl};
    static constexpr std::string_view filled[] = {"linearised_depth"};
    static constexpr step passes[] = {
        {.name = "linearise", .files = linearising, .kind = step_kind::texels, .writes = filled}};
    static constexpr const glsl_file* files[] = {&linearised_depth_glsl};
    static constexpr part description{
        .kind = role::depth_encoding,
        .name = "linearised_depth",
        .summary = "the depth image holds device depth, which a first pass makes linear",
        .source = "stochastic-depth-ao 2020, 4.4",
        .files = files,
        .resources = images,
        .steps = passes,
    };
};

}
