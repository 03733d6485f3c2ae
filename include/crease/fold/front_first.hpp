// SPDX-License-Identifier: MIT
#pragma once

#include <crease/fold/front.hpp>

namespace crease {

inline constexpr glsl_file front_first_glsl{
    "fold/front_first.glsl",
#include <crease/fold/front_first.glsl>
};

struct front_first_part : front_part {
    using needs = traits<front_test>;
    static constexpr const glsl_file* helpers[] = {&fold_groups_glsl, &fold_front_glsl};
    static constexpr part description{
        .kind = role::fold,
        .name = "front_first",
        .summary = "looks at the front surface of each tap first, and behind it only where that may matter",
        .source = "stochastic-depth-ao 2020, 6.3",
        .glsl = &front_first_glsl,
        .helpers = helpers,
        .numbers = takes,
        .settings = reads,
        .needs = needs::list,
        .packs = &front_dropped_glsl,
    };
};

/// Fold: the front surface first, and the layers behind it only where they may matter.
template <int Angle = 1>
struct front_first : front_first_part {
    static constexpr int numbers[] = {Angle};
};

}
