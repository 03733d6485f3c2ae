// SPDX-License-Identifier: MIT
#pragma once

#include <crease/compose/core_files.hpp>
#include <crease/parts/filter/planes.hpp>

namespace crease {

inline constexpr glsl_file plane_filter_glsl{
    "filter/plane_filter.glsl",
#include <crease/filter/plane_filter.glsl>
};

struct plane_filter_part {
    using needs = traits<handed_on_normals>;
    static constexpr number takes[] = {{"radius", 1, 4, 2, "texels to either side"}};
    static constexpr setting reads[] = {plane_reach_setting};
    static constexpr const glsl_file* files[] = {&normal_glsl, &plane_weight_glsl};
    // It reads near its pixel, so columns of workgroups would not pay.
    static constexpr const glsl_file* filtering[] = {&plane_filter_glsl, &pixel_glsl};
    static constexpr step passes[] = {{.name = "plane_filter", .files = filtering}};
    static constexpr part description{
        .kind = role::filter,
        .name = "plane_filter",
        .summary = "blur over a square of pixels, weighed by tangent planes and normals",
        .source = "",
        .files = files,
        .numbers = takes,
        .settings = reads,
        .steps = passes,
        .needs = needs::list,
    };
};

/// Filter: a blur over 2 `Radius` + 1 texels each way that keeps to a surface.
template <int Radius = 2>
struct plane_filter : plane_filter_part {
    static constexpr int numbers[] = {Radius};
};

}
