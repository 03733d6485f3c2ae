// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/depth/layers.hpp>
#include <crease/parts/estimator/visibility_settings.hpp>
#include <crease/parts/estimator/volume.hpp>
#include <crease/parts/receivers/thin_layers.hpp>
#include <crease/parts/sampler/taps.hpp>

namespace crease {

inline constexpr glsl_file line_volume_glsl{
    "estimator/line_volume.glsl",
#include <crease/estimator/line_volume.glsl>
};

/// Estimator: volumetric obscurance by lines. Of a sphere it is what is filled beyond the half that a plane
/// fills, as a share of the other half.
struct line_volume {
    using needs = traits<line_taps, depth_layers>;
    static constexpr setting reads[] = {
        {"falloff", 1, 0.01f, 100,
         "distance over which a surface before the volume ceases to count, in radii"},
        strength_setting(1),
        exponent_setting(1),
    };
    static constexpr const glsl_file* files[] = {&volume_glsl, &line_volume_glsl};
    static constexpr part description{
        .kind = role::estimator,
        .name = "line_volume",
        .summary = "the share of the volume around the receiver that is filled, by lines",
        .source = "statistical-volumetric-obscurance 2015, 2.3, A.2",
        .files = files,
        .settings = reads,
        .needs = needs::list,
        .offers = traits<both_sides>::list,
    };
};

}
