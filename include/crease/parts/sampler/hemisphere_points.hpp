// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/output/bent_cone.hpp>
#include <crease/parts/sampler/taps.hpp>

namespace crease {

inline constexpr glsl_file hemisphere_points_glsl{
    "sampler/hemisphere_points.glsl",
#include <crease/sampler/hemisphere_points.glsl>
};

struct hemisphere_points_part {
    static constexpr number takes[] = {{"count", 1, 256, 16, "points in the hemisphere"}};
    static constexpr const glsl_file* files[] = {&point_tap_glsl, &texel_ray_glsl, &radius_inside_glsl,
                                                 &hemisphere_points_glsl};
    static constexpr part description{
        .kind = role::sampler,
        .name = "hemisphere_points",
        .summary = "points in the hemisphere over the receiver, turned by a random angle per pixel",
        .source = "stochastic-depth-ao 2020, 4.1, Algorithm 1",
        .files = files,
        .numbers = takes,
        .offers = traits<point_taps, known_directions>::list,
    };
};

/// Sampler: `Count` points in the normal-oriented hemisphere.
template <int Count = 16>
struct hemisphere_points : hemisphere_points_part {
    static constexpr int numbers[] = {Count};
};

}
