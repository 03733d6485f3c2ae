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
    {"low", 0.0840, 0.0614, 0.857, 0.32},          {"medium", 0.0712, 0.0487, 0.907, 0.74},
    {"high", 0.0661, 0.0455, 0.915, 1.22},         {"ultra", 0.0644, 0.0446, 0.926, 1.49},
    {"ultra_layers", 0.0527, 0.0420, 0.925, 8.11}, // with a guard band of a tenth of the width
};

}
