// SPDX-License-Identifier: MIT
#pragma once

#include <crease/compose/core_files.hpp>
#include <crease/compose/part.hpp>

namespace crease {

inline constexpr glsl_file bilateral_glsl{
    "filter/bilateral.glsl",
#include <crease/filter/bilateral.glsl>
};

struct bilateral_part {
    static constexpr number takes[] = {{"radius", 1, 16, 3, "texels to either side"}};
    static constexpr setting reads[] = {
        {"sharpness", 32, 0, 1000, "how fast a weight falls with the difference in depth, per radius"},
    };
    static constexpr step_constant across[] = {{"axis", 0}};
    static constexpr step_constant down[] = {{"axis", 1}};
    // It reads near its pixel, so columns of workgroups would not pay.
    static constexpr const glsl_file* files[] = {&bilateral_glsl, &pixel_glsl};
    static constexpr step passes[] = {
        {.name = "bilateral_x", .files = files, .constants = across},
        {.name = "bilateral_y", .files = files, .constants = down},
    };
    static constexpr part description{
        .kind = role::filter,
        .name = "bilateral",
        .summary = "separable cross-bilateral blur with depth-slope correction",
        .source = "stochastic-depth-ao 2020, 8.1",
        .numbers = takes,
        .settings = reads,
        .steps = passes,
    };
};

/// Filter: a blur over 2 `Radius` + 1 texels each way that keeps to a surface.
template <int Radius = 3>
struct bilateral : bilateral_part {
    static constexpr int numbers[] = {Radius};
};

}
