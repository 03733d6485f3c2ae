// SPDX-License-Identifier: MIT
#pragma once

#include <crease/compose/part.hpp>

namespace crease {

inline constexpr glsl_file hilbert_noise_glsl{
    "noise/hilbert_noise.glsl",
#include <crease/noise/hilbert_noise.glsl>
};

/// Noise: Roberts' R sequence of three numbers along a Hilbert curve of 64 x 64 pixels, so that pixels near
/// each other divide the numbers evenly.
struct hilbert_noise {
    static constexpr const glsl_file* files[] = {&hilbert_noise_glsl};
    static constexpr part description{
        .kind = role::noise,
        .name = "hilbert_noise",
        .summary = "a low-discrepancy sequence along a Hilbert curve",
        .source = "Roberts 2018, The Unreasonable Effectiveness of Quasirandom Sequences",
        .files = files,
    };
};

}
