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
    double time;        ///< of all passes but those of geometry, at 1280 x 720 on lavapipe;
                        ///< directions:8x4/single_layer/hbao/bilateral is 1
};

inline constexpr preset_figures measured_presets[] = {
    {"low", 0.0834, 0.0608, 0.858, 0.31},          {"medium", 0.0707, 0.0480, 0.908, 0.74},
    {"high", 0.0678, 0.0453, 0.927, 1.03},         {"ultra", 0.0648, 0.0432, 0.935, 1.51},
    {"ultra_layers", 0.0416, 0.0337, 0.945, 2.93}, // with a guard band of a tenth of the width
};

}
