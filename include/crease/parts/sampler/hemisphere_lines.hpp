// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/sampler/taps.hpp>

namespace crease {

inline constexpr glsl_file hemisphere_lines_glsl{
    "sampler/hemisphere_lines.glsl",
#include <crease/sampler/hemisphere_lines.glsl>
};

struct hemisphere_lines_part {
    static constexpr number takes[] = {{"count", 1, 256, 12, "lines through the hemisphere"}};
    static constexpr const glsl_file* files[] = {&line_tap_glsl,    &texel_ray_glsl,  &share_inside_glsl,
                                                 &disk_spiral_glsl, &disk_lines_glsl, &hemisphere_lines_glsl};
    static constexpr part description{
        .kind = role::sampler,
        .name = "hemisphere_lines",
        .summary = "lines along the view rays through the hemisphere over the receiver",
        .source = "statistical-volumetric-obscurance 2015, 2.3",
        .files = files,
        .numbers = takes,
        .offers = traits<line_taps>::list,
    };
};

/// Sampler: `Count` lines through the normal-oriented hemisphere of the radius.
template <int Count = 12>
struct hemisphere_lines : hemisphere_lines_part {
    static constexpr int numbers[] = {Count};
};

}
