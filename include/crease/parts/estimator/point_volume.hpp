// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/depth/layers.hpp>
#include <crease/parts/estimator/visibility_settings.hpp>
#include <crease/parts/estimator/volume.hpp>
#include <crease/parts/receivers/thin_layers.hpp>
#include <crease/parts/sampler/taps.hpp>

namespace crease {

inline constexpr glsl_file point_volume_glsl{
    "estimator/point_volume.glsl",
#include <crease/estimator/point_volume.glsl>
};

/// Estimator: volumetric obscurance by points, as the first SSAO. Of a sphere it is what is filled beyond the
/// half that a plane fills, as a share of the other half.
struct point_volume {
    using needs = traits<point_taps, depth_layers>;
    static constexpr setting reads[] = {
        {"bias", 0.01f, 0, 1,
         "height over or under the tangent plane, in radii, up to which a point is left out"},
        {"falloff", 1, 0.01f, 100,
         "distance over which a surface before the volume ceases to count, in radii"},
        strength_setting(1),
        exponent_setting(1),
    };
    static constexpr const glsl_file* files[] = {&volume_glsl, &point_volume_glsl};
    static constexpr part description{
        .kind = role::estimator,
        .name = "point_volume",
        .summary = "the share of the volume around the receiver that is filled, by points",
        .source = "statistical-volumetric-obscurance 2015, 2.2, (4.1), A.2",
        .files = files,
        .settings = reads,
        .needs = needs::list,
        .offers = traits<both_sides>::list,
    };
};

}
