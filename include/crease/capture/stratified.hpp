// SPDX-License-Identifier: MIT
#pragma once

#include <crease/capture/noise.hpp>
#include <crease/capture/subsets.hpp>

namespace crease {

inline constexpr glsl_file stratified_glsl{
    "capture/stratified.glsl",
#include <crease/capture/stratified.glsl>
};

/// Layer sampling: random subsets of an even size. The default.
struct stratified {
    static constexpr const glsl_file* helpers[] = {&hashed_noise_glsl, &fragment_noise_glsl};
    static constexpr resource table[] = {{.name = "subsets",
                                          .texels = format::r32_uint,
                                          .life = lifetime::constant,
                                          .size = {.fixed_width = 256, .fixed_height = 257},
                                          .fill = fill_subsets}};
    static constexpr part description{
        .kind = role::layer_sampling,
        .name = "stratified",
        .summary = "a random subset of floor(opacity S + xi) of the S samples",
        .source = "stochastic-depth-ao 2020, 5.1, Algorithm 5",
        .glsl = &stratified_glsl,
        .helpers = helpers,
        .resources = table,
    };
};

}
