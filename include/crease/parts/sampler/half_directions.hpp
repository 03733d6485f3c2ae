// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/output/bent_cone.hpp>
#include <crease/parts/sampler/taps.hpp>

namespace crease {

inline constexpr glsl_file half_directions_glsl{
    "sampler/half_directions.glsl",
#include <crease/sampler/half_directions.glsl>
};

struct half_directions_part {
    static constexpr number takes[] = {
        {"count", 1, 64, 1, "directions"},
        {"steps", 1, 64, 8, "taps along each direction"},
        {"power", 1, 4, 2, "power of a step's index by which its distance grows; 1: even steps"},
    };
    static constexpr const glsl_file* files[] = {&slice_tap_glsl, &stepped_tap_glsl, &half_directions_glsl};
    static constexpr part description{
        .kind = role::sampler,
        .name = "half_directions",
        .summary = "directions drawn by the cosine lobe, each of which counts the same",
        .source = "importance sampling of the cosine lobe's azimuths",
        .files = files,
        .numbers = takes,
        .offers = traits<slice_taps, movable_taps, known_directions>::list,
    };
};

/// Sampler: `Count` directions of `Steps` taps each, drawn as often as their half slices hold of the cosine
/// lobe. Distances grow by the `Power` of a step's index; the first tap is a texel away. Taps beside the
/// picture look at its edge.
template <int Count = 1, int Steps = 8, int Power = 2>
struct half_directions : half_directions_part {
    static constexpr int numbers[] = {Count, Steps, Power};
};

}
