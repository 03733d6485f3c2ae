// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/sampler/taps.hpp>

namespace crease {

inline constexpr glsl_file tap_grid_glsl{
    "sampler/tap_grid.glsl",
#include <crease/sampler/tap_grid.glsl>
};

struct tap_grid_part {
    static constexpr number takes[] = {{"side", 2, 16, 6, "taps along each side of the square"}};
    static constexpr const glsl_file* files[] = {&screen_tap_glsl, &share_inside_glsl, &tap_grid_glsl};
    static constexpr part description{
        .kind = role::sampler,
        .name = "tap_grid",
        .summary = "an even grid of taps over the square around the radius, the same for every pixel",
        .source = "Hoang and Low 2010, Multi-Resolution Screen-Space Ambient Occlusion",
        .files = files,
        .numbers = takes,
        .offers = traits<screen_taps, movable_taps>::list,
    };
};

/// Sampler: `Side` x `Side` taps of an even grid. It leaves no noise and, where the square is many texels
/// large, bands; with `multi_resolution` it is a few texels large.
template <int Side = 6>
struct tap_grid : tap_grid_part {
    static constexpr int numbers[] = {Side};
};

}
