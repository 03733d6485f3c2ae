// SPDX-License-Identifier: MIT
#pragma once

#include <crease/compose/part.hpp>

namespace crease {

inline constexpr glsl_file hilbert_r2_noise_glsl{
    "noise/hilbert_r2_noise.glsl",
#include <crease/noise/hilbert_r2_noise.glsl>
};

/// Noise: Roberts' R2 sequence, and the golden ratio's for the third number, along a Hilbert curve of 64 x 64
/// pixels, so that pixels near each other divide the numbers evenly.
struct hilbert_r2_noise {
    static constexpr const glsl_file* files[] = {&hilbert_r2_noise_glsl};
    static constexpr part description{
        .kind = role::noise,
        .name = "hilbert_r2_noise",
        .summary = "the R2 sequence along a Hilbert curve",
        .source = "Roberts 2018, The Unreasonable Effectiveness of Quasirandom Sequences",
        .files = files,
    };
};

}
