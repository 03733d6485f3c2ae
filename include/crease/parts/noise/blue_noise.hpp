// SPDX-License-Identifier: MIT
#pragma once

#include <crease/compose/part.hpp>
#include <crease/parts/noise/blue_noise_tile.hpp>

#include <cstdint>

namespace crease {

inline constexpr glsl_file blue_noise_glsl{
    "noise/blue_noise.glsl",
#include <crease/noise/blue_noise.glsl>
};

/// Noise: a tile of blue noise, whose differences are all between pixels near each other, so that what a blur
/// leaves is fine grain. The image `blue_noise`, 64 x 64 texels, is constant.
struct blue_noise {
    /// The value of a character of `blue_noise_ranks`, 0 to 63.
    static constexpr std::uint32_t digit(char c) {
        return static_cast<std::uint32_t>(c - '#' - (c > '?') - (c > '\\'));
    }
    /// The rank at a place of the tile, which repeats.
    static constexpr std::uint32_t rank(unsigned x, unsigned y) {
        const char* two =
            blue_noise_ranks + 2 * (y % blue_noise_side * blue_noise_side + x % blue_noise_side);
        return digit(two[0]) * 64 + digit(two[1]);
    }
    static constexpr void fill(array_view<std::uint32_t> texels) {
        for (unsigned y = 0; y < blue_noise_side; ++y)
            for (unsigned x = 0; x < blue_noise_side; ++x)
                texels[y * blue_noise_side + x] =
                    rank(x, y) / 2 << 21 | rank(x + 21, y + 39) / 2 << 10 | rank(x + 43, y + 13) / 4;
    }
    static constexpr resource images[] = {
        {.name = "blue_noise",
         .texels = format::r32_uint,
         .life = lifetime::constant,
         .size = {.fixed_width = blue_noise_side, .fixed_height = blue_noise_side},
         .fill = fill}};
    static constexpr const glsl_file* files[] = {&blue_noise_glsl};
    static constexpr part description{
        .kind = role::noise,
        .name = "blue_noise",
        .summary = "numbers that differ most between pixels near each other, from a tile",
        .source = "Ulichney 1993, The void-and-cluster method for dither array generation",
        .files = files,
        .resources = images,
    };
};

}
