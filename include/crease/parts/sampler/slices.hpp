// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/output/bent_cone.hpp>
#include <crease/parts/sampler/taps.hpp>

namespace crease {

inline constexpr glsl_file slices_glsl{
    "sampler/slices.glsl",
#include <crease/sampler/slices.glsl>
};

struct slices_part {
    static constexpr number takes[] = {
        {"count", 1, 32, 3, "slices, dividing the half circle evenly"},
        {"steps", 1, 64, 3, "taps along each of the two directions of a slice"},
        {"power", 1, 4, 2, "power of a step's index by which its distance grows; 1: even steps"},
    };
    static constexpr const glsl_file* files[] = {&slice_tap_glsl, &stepped_tap_glsl, &slices_glsl};
    static constexpr part description{
        .kind = role::sampler,
        .name = "slices",
        .summary =
            "marches both ways along slices through the eye, with a random angle and first step per pixel",
        .source = "Jimenez et al. 2016, Practical Realtime Strategies for Accurate Indirect Occlusion",
        .files = files,
        .numbers = takes,
        .offers = traits<screen_taps, ordered_taps, slice_taps, movable_taps, known_directions>::list,
    };
};

/// Sampler: `Count` slices, pairs of opposite directions of `Steps` taps each. Distances grow by the `Power`
/// of a step's index; the first tap is a texel away. Taps beside the picture look at its edge.
template <int Count = 3, int Steps = 3, int Power = 2>
struct slices : slices_part {
    static constexpr int numbers[] = {Count, Steps, Power};
};

}
