// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace crease::tools {

/// What a preset was measured to be; docs/benchmarks.md says how. Errors are of nine views of three scenes at
/// 640 x 360, the background left out.
struct preset_figures {
    std::string_view preset;
    double rmse_hard;   ///< to the hard truth, with `cosine_bitmask` behind the preset, which aims at it
    double rmse_linear; ///< to the linear truth
    double ssim_linear; ///< structural similarity to the linear truth
    double time;        ///< of all passes at 1280 x 720, directions:8x4/single_layer/hbao/bilateral being 1
};

inline constexpr preset_figures measured_presets[] = {
    {"low", 0.0845, 0.0618, 0.854, 0.33},  {"medium", 0.0718, 0.0492, 0.903, 0.74},
    {"high", 0.0667, 0.0460, 0.911, 1.2},  {"ultra", 0.0648, 0.0448, 0.924, 1.5},
    {"ultra_layers", 0.06, 0.045, 0.9, 2},
};

}
