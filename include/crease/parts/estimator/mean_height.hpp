// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/depth/areas.hpp>
#include <crease/parts/estimator/visibility_settings.hpp>
#include <crease/parts/sampler/taps.hpp>

namespace crease {

inline constexpr glsl_file mean_height_glsl{
    "estimator/mean_height.glsl",
#include <crease/estimator/mean_height.glsl>
};

struct mean_height_part {
    using needs = traits<sample_area_taps>;
    static constexpr number takes[] = {
        {"oriented", 0, 1, 1, "whether heights are along the normal (4.5), else along the view (4.3)"}};
    static constexpr setting reads[] = {
        {"bias", 0, 0, 1, "height, in radii, up to which a mean occludes nothing"},
        {"threshold", 0.25f, 0.01f, 16, "height of the box, in radii"},
        {"falloff", 0.3f, 0, 16, "over how many radii beyond the box the occlusion falls to nothing"},
        strength_setting(0.9f),
        exponent_setting(1),
    };
    static constexpr const glsl_file* files[] = {&mean_height_glsl};
    static constexpr part description{
        .kind = role::estimator,
        .name = "mean_height",
        .summary = "statistical volumetric obscurance: the mean height of what a box holds",
        .source = "statistical-volumetric-obscurance 2015, 4.2 to 4.5, A.2",
        .files = files,
        .numbers = takes,
        .settings = reads,
        .needs = needs::list,
        .offers = traits<area_means>::list,
    };
};

/// Estimator: statistical volumetric obscurance, along the normal where `Oriented` is 1. The defaults aim at
/// the `linear` truth.
template <int Oriented = 1>
struct mean_height : mean_height_part {
    static constexpr int numbers[] = {Oriented};
};

}
