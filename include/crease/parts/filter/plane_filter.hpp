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
    static constexpr number takes[] = {{"radius", 1, 4, 2, "texels to either side: 2 is 5 x 5"}};
    static constexpr setting reads[] = {plane_reach_setting};
    static constexpr const glsl_file* files[] = {&encoding_normal_glsl, &plane_glsl};
    // It reads near its pixel, so columns of workgroups would not pay.
    static constexpr const glsl_file* filtering[] = {&plane_filter_glsl, &pixel_glsl};
    static constexpr step passes[] = {{.name = "plane_filter", .files = filtering}};
    static constexpr part description{
        .kind = role::filter,
        .name = "plane_filter",
        .summary = "joint bilateral blur over a square, weighed by tangent planes and normals",
        .source = "Petschnigg et al. 2004, Digital Photography with Flash and No-Flash Image Pairs, 3",
        .files = files,
        .numbers = takes,
        .settings = reads,
        .steps = passes,
        .needs = needs::list,
    };
};

/// Filter: a blur over 2 `Radius` + 1 texels each way, in one pass, that keeps to a surface. A texel counts
/// by a Gaussian with the standard deviation 3/4 `Radius`, times max(0, 1 - h / (`plane_reach` R)) of its
/// distance h from the tangent plane, times max(0.2, cos^8) of the angle between the normals. Beyond the
/// picture its edge counts on.
template <int Radius = 2>
struct plane_filter : plane_filter_part {
    static constexpr int numbers[] = {Radius};
};

}
