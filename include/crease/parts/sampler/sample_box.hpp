// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/depth/areas.hpp>
#include <crease/parts/sampler/taps.hpp>

namespace crease {

inline constexpr glsl_file sample_box_glsl{
    "sampler/sample_box.glsl",
#include <crease/sampler/sample_box.glsl>
};

/// Sampler: one area, that of the box around the receiver.
struct sample_box {
    using needs = traits<layers_of_areas>;
    static constexpr const glsl_file* files[] = {&area_tap_glsl, &sample_area_glsl, &sample_box_glsl};
    static constexpr part description{
        .kind = role::sampler,
        .name = "sample_box",
        .summary = "one area: that of the box around the receiver, half a radius wide",
        .source = "statistical-volumetric-obscurance 2015, 4.2",
        .files = files,
        .needs = needs::list,
        .offers = traits<area_taps, sample_area_taps>::list,
    };
};

}
