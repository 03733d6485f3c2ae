// SPDX-License-Identifier: MIT
#pragma once

#include <crease/depth/areas.hpp>
#include <crease/sampler/taps.hpp>

namespace crease {

inline constexpr glsl_file sample_box_glsl{
    "sampler/sample_box.glsl",
#include <crease/sampler/sample_box.glsl>
};

/// Sampler: one area, that of the box around the receiver.
struct sample_box {
    using needs = traits<area_layers>;
    static constexpr const glsl_file* helpers[] = {&area_tap_glsl, &sample_area_glsl};
    static constexpr part description{
        .kind = role::sampler,
        .name = "sample_box",
        .summary = "one area: that of the box around the receiver, half a radius wide",
        .source = "statistical-volumetric-obscurance 2015, 4.2",
        .glsl = &sample_box_glsl,
        .helpers = helpers,
        .needs = needs::list,
        .offers = traits<area_taps, sample_area_taps>::list,
    };
};

}
