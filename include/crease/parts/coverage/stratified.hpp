// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/coverage/noise.hpp>
#include <crease/parts/coverage/opacity.hpp>
#include <crease/parts/coverage/subsets.hpp>

namespace crease {

inline constexpr glsl_file stratified_glsl{
    "coverage/stratified.glsl",
#include <crease/coverage/stratified.glsl>
};

/// Coverage: random subsets of an even size. The default.
struct stratified {
    static constexpr resource table[] = {{.name = "subsets",
                                          .texels = format::r32_uint,
                                          .life = lifetime::constant,
                                          .size = {.fixed_width = 256, .fixed_height = 257},
                                          .shape = shape_subsets}};
    static constexpr const glsl_file* files[] = {&hashed_noise_glsl, &fragment_noise_glsl, &stratified_glsl};
    static constexpr part description{
        .kind = role::coverage,
        .name = "stratified",
        .summary = "a random subset of floor(opacity S + xi) of the S samples",
        .source = "stochastic-depth-ao 2020, 5.1, Algorithm 5",
        .files = files,
        .settings = opacity_setting,
        .resources = table,
    };
};

}
