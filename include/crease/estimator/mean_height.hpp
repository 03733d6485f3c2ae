// SPDX-License-Identifier: MIT
#pragma once

#include <crease/depth/areas.hpp>
#include <crease/sampler/taps.hpp>

namespace crease {

inline constexpr glsl_file mean_height_glsl{
    "estimator/mean_height.glsl",
#include <crease/estimator/mean_height.glsl>
};

inline constexpr glsl_file mean_height_areas_glsl{
    "estimator/mean_height_areas.glsl",
#include <crease/estimator/mean_height_areas.glsl>
};

struct mean_height_part {
    using needs = traits<sample_area_taps>;
    static constexpr extra more[] = {{&area_means::value, &mean_height_areas_glsl}};
    static constexpr number takes[] = {
        {"oriented", 0, 1, 1, "whether heights are along the normal (4.5), else along the view (4.3)"}};
    static constexpr setting reads[] = {
        {"bias", &parameters::bias, 0, 0, 1, "height, in radii, up to which a mean occludes nothing"},
        {"threshold", &parameters::threshold, 0.25f, 0.01f, 16, "height of the box, in radii"},
        {"falloff", &parameters::falloff, 0.3f, 0, 16,
         "over how many radii beyond the box the occlusion falls to nothing"},
        {"strength", &parameters::strength, 0.9f, 0, 16, "factor of the occlusion"},
        {"exponent", &parameters::exponent, 1, 0.01f, 16, "power of the visibility"},
    };
    static constexpr part description{
        .kind = role::estimator,
        .name = "mean_height",
        .summary = "statistical volumetric obscurance: the mean height of what a box holds",
        .source = "statistical-volumetric-obscurance 2015, 4.2 to 4.5, A.2",
        .glsl = &mean_height_glsl,
        .numbers = takes,
        .settings = reads,
        .needs = needs::list,
        .offers = traits<area_means>::list,
        .extras = more,
    };
};

/// Estimator: statistical volumetric obscurance, along the normal where `Oriented` is 1. The defaults aim at
/// the `linear` truth.
template <int Oriented = 1>
struct mean_height : mean_height_part {
    static constexpr int numbers[] = {Oriented};
};

}
