// SPDX-License-Identifier: MIT
#pragma once

#include <crease/compose/core_files.hpp>
#include <crease/parts/filter/planes.hpp>

namespace crease {

inline constexpr glsl_file separable_plane_filter_glsl{
    "filter/separable_plane_filter.glsl",
#include <crease/filter/separable_plane_filter.glsl>
};

struct separable_plane_filter_part {
    using needs = traits<handed_on_normals>;
    static constexpr number takes[] = {{"radius", 1, 8, 2, "texels to either side"}};
    static constexpr setting reads[] = {plane_reach_setting};
    static constexpr step_constant across[] = {{"axis", 0}};
    static constexpr step_constant down[] = {{"axis", 1}};
    static constexpr const glsl_file* files[] = {&normal_glsl, &plane_weight_glsl};
    // It reads near its pixel, so columns of workgroups would not pay.
    static constexpr const glsl_file* filtering[] = {&separable_plane_filter_glsl, &pixel_glsl};
    static constexpr step passes[] = {
        {.name = "plane_filter_x", .files = filtering, .constants = across},
        {.name = "plane_filter_y", .files = filtering, .constants = down},
    };
    static constexpr part description{
        .kind = role::filter,
        .name = "separable_plane_filter",
        .summary = "blur along rows and then columns, weighed by tangent planes and normals",
        .source = "",
        .files = files,
        .numbers = takes,
        .settings = reads,
        .steps = passes,
        .needs = needs::list,
    };
};

/// Filter: `plane_filter` in two passes, which cost less with wide radii.
template <int Radius = 2>
struct separable_plane_filter : separable_plane_filter_part {
    static constexpr int numbers[] = {Radius};
};

}
