// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/sampler/taps.hpp>

namespace crease {

inline constexpr glsl_file sphere_lines_glsl{
    "sampler/sphere_lines.glsl",
#include <crease/sampler/sphere_lines.glsl>
};

struct sphere_lines_part {
    static constexpr number takes[] = {{"count", 1, 256, 12, "lines through the sphere"}};
    static constexpr const glsl_file* files[] = {&line_tap_glsl,    &texel_ray_glsl,  &share_inside_glsl,
                                                 &disk_spiral_glsl, &disk_lines_glsl, &sphere_lines_glsl};
    static constexpr part description{
        .kind = role::sampler,
        .name = "sphere_lines",
        .summary = "lines along the view rays through the sphere around the receiver",
        .source = "statistical-volumetric-obscurance 2015, 2.3",
        .files = files,
        .numbers = takes,
        .offers = traits<line_taps>::list,
    };
};

/// Sampler: `Count` lines through the sphere of the radius.
template <int Count = 12>
struct sphere_lines : sphere_lines_part {
    static constexpr int numbers[] = {Count};
};

}
