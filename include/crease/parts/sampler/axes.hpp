// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/output/bent_cone.hpp>
#include <crease/parts/sampler/taps.hpp>

namespace crease {

inline constexpr glsl_file axes_glsl{
    "sampler/axes.glsl",
#include <crease/sampler/axes.glsl>
};

struct axes_part {
    static constexpr number takes[] = {
        {"steps", 1, 64, 8, "taps along each of the four directions"},
        {"reach", 1, 1024, 24, "the farthest of them, texels; none is beyond the radius"},
    };
    static constexpr const glsl_file* files[] = {&slice_tap_glsl, &axes_glsl};
    static constexpr part description{
        .kind = role::sampler,
        .name = "axes",
        .summary = "marches both ways along the picture's rows and columns, the same for every pixel",
        .source =
            "a-buffer-ssao 2013, V.B; Bavoil 2011, Horizon-Based Ambient Occlusion using Compute Shaders",
        .files = files,
        .numbers = takes,
        .offers = traits<screen_taps, ordered_taps, slice_taps, movable_taps, known_directions>::list,
    };
};

/// Sampler: `Steps` taps each way along the row and the column of a pixel, at even steps of a texel or more
/// up to the radius, but no farther than `Reach` texels, so that `compute_strips` with an apron as wide finds
/// all of them in shared memory. It leaves no noise, and the bands of four directions.
template <int Steps = 8, int Reach = 24>
struct axes : axes_part {
    static constexpr int numbers[] = {Steps, Reach};
};

}
