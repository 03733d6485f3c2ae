// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/sampler/taps.hpp>

namespace crease {

inline constexpr glsl_file poisson_disk_glsl{
    "sampler/poisson_disk.glsl",
#include <crease/sampler/poisson_disk.glsl>
};

struct poisson_disk_part {
    static constexpr number takes[] = {{"count", 1, 256, 16, "taps in the disk of the radius"}};
    static constexpr const glsl_file* files[] = {&screen_tap_glsl, &share_inside_glsl, &disk_spiral_glsl,
                                                 &poisson_disk_glsl};
    static constexpr part description{
        .kind = role::sampler,
        .name = "poisson_disk",
        .summary = "taps spread evenly over the disk of the radius, turned by a random angle per pixel",
        .source = "a-buffer-ssao 2013, V A",
        .files = files,
        .numbers = takes,
        .offers = traits<screen_taps, movable_taps>::list,
    };
};

/// Sampler: `Count` taps of a Poisson disk.
template <int Count = 16>
struct poisson_disk : poisson_disk_part {
    static constexpr int numbers[] = {Count};
};

}
