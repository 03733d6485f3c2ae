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
    static constexpr number takes[] = {{"radius", 1, 8, 3, "texels to either side: 3 is 7 x 7"}};
    static constexpr setting reads[] = {plane_reach_setting};
    static constexpr step_constant across[] = {{"axis", 0}};
    static constexpr step_constant down[] = {{"axis", 1}};
    static constexpr const glsl_file* files[] = {&encoding_normal_glsl, &plane_glsl};
    // It reads near its pixel, so columns of workgroups would not pay.
    static constexpr const glsl_file* filtering[] = {&separable_plane_filter_glsl, &pixel_glsl};
    static constexpr step passes[] = {
        {.name = "plane_filter_x", .files = filtering, .constants = across},
        {.name = "plane_filter_y", .files = filtering, .constants = down},
    };
    static constexpr part description{
        .kind = role::filter,
        .name = "separable_plane_filter",
        .summary = "joint bilateral blur along rows, then columns, weighed by tangent planes and normals",
        .source = "Petschnigg et al. 2004, Digital Photography with Flash and No-Flash Image Pairs, 3",
        .files = files,
        .numbers = takes,
        .settings = reads,
        .steps = passes,
        .needs = needs::list,
    };
};

/// Filter: the weights of `plane_filter` along rows and then along columns, of which the second takes what
/// the first has made: nearly the same for a fraction of the fetches.
template <int Radius = 3>
struct separable_plane_filter : separable_plane_filter_part {
    static constexpr int numbers[] = {Radius};
};

}
