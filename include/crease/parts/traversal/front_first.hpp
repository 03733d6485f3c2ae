// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/traversal/front.hpp>

namespace crease {

inline constexpr glsl_file front_first_glsl{
    "traversal/front_first.glsl",
#include <crease/traversal/front_first.glsl>
};

struct front_first_part : front_part {
    using needs = traits<layers_behind_front, one_resolution>;
    static constexpr const glsl_file* files[] = {&front_glsl, &front_first_glsl};
    static constexpr part description{
        .kind = role::layer_traversal,
        .name = "front_first",
        .summary = "looks at the front surface of each tap first, and behind it only where that may matter",
        .source = "stochastic-depth-ao 2020, 6.3",
        .files = files,
        .numbers = takes,
        .settings = reads,
        .needs = needs::list,
    };
};

/// Layer traversal: the front surface first, and the layers behind it only where they may matter.
template <int Angle = 1>
struct front_first : front_first_part {
    static constexpr int numbers[] = {Angle};
};

}
