// SPDX-License-Identifier: MIT
#pragma once

#include <crease/compose/part.hpp>

namespace crease {

inline constexpr glsl_file tiled_noise_glsl{
    "noise/tiled_noise.glsl",
#include <crease/noise/tiled_noise.glsl>
};

struct tiled_noise_part {
    static constexpr number takes[] = {
        {"side", 1, 16, 4, "pixels to a side of the tile; with 1 every pixel has the same taps"}};
    static constexpr const glsl_file* files[] = {&tiled_noise_glsl};
    static constexpr part description{
        .kind = role::noise,
        .name = "tiled_noise",
        .summary = "numbers that differ within a small tile of pixels and repeat from tile to tile",
        .source = "statistical-volumetric-obscurance 2015, 2.2",
        .files = files,
        .numbers = takes,
    };
};

/// Noise: a tile of `Side` x `Side` pixels, for a blur of about that width to even out.
template <int Side = 4>
struct tiled_noise : tiled_noise_part {
    static constexpr int numbers[] = {Side};
};

}
