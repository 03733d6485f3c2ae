// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/sampler/taps.hpp>

namespace crease {

inline constexpr glsl_file sphere_points_glsl{
    "sampler/sphere_points.glsl",
#include <crease/sampler/sphere_points.glsl>
};

struct sphere_points_part {
    static constexpr number takes[] = {{"count", 1, 256, 16, "points in the sphere"}};
    static constexpr const glsl_file* files[] = {&point_tap_glsl, &texel_ray_glsl, &radius_inside_glsl,
                                                 &sphere_points_glsl};
    static constexpr part description{
        .kind = role::sampler,
        .name = "sphere_points",
        .summary = "points spread evenly through the sphere around the receiver",
        .source = "statistical-volumetric-obscurance 2015, 2.2",
        .files = files,
        .numbers = takes,
        .offers = traits<point_taps>::list,
    };
};

/// Sampler: `Count` points in the sphere of the radius.
template <int Count = 16>
struct sphere_points : sphere_points_part {
    static constexpr int numbers[] = {Count};
};

}
