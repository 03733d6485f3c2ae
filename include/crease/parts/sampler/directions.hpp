// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/output/bent_cone.hpp>
#include <crease/parts/sampler/taps.hpp>

namespace crease {

inline constexpr glsl_file directions_glsl{
    "sampler/directions.glsl",
#include <crease/sampler/directions.glsl>
};

struct directions_part {
    static constexpr number takes[] = {
        {"count", 1, 64, 8, "directions, dividing the circle evenly"},
        {"steps", 1, 64, 4, "taps along each direction"},
        {"power", 1, 4, 2, "power of a step's index by which its distance grows; 1: even steps"},
    };
    static constexpr const glsl_file* files[] = {&slice_tap_glsl, &share_inside_glsl, &directions_glsl};
    static constexpr part description{
        .kind = role::sampler,
        .name = "directions",
        .summary = "marches along directions on the screen, with a random angle and first step per pixel",
        .source = "stochastic-depth-ao 2020, 4.2, Algorithms 2 and 3",
        .files = files,
        .numbers = takes,
        .offers = traits<screen_taps, ordered_taps, slice_taps, movable_taps, known_directions>::list,
    };
};

/// Sampler: `Count` directions of `Steps` taps each, at distances that grow by the `Power` of their index.
template <int Count = 8, int Steps = 4, int Power = 2>
struct directions : directions_part {
    static constexpr int numbers[] = {Count, Steps, Power};
};

}
