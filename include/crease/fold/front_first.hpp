// SPDX-License-Identifier: MIT
#pragma once

#include <crease/fold/groups.hpp>

namespace crease {

inline constexpr glsl_file front_first_glsl{
    "fold/front_first.glsl",
#include <crease/fold/front_first.glsl>
};

inline constexpr glsl_file front_dropped_glsl{
    "fold/front_dropped.glsl",
#include <crease/fold/front_dropped.glsl>
};

/// A test by which the front layer of a tap settles it: crease_front_settles.
CREASE_TRAIT(front_test, estimator,
             "the fold needs a test of the front surface, which the estimator does not have");

struct front_first_part {
    using needs = traits<front_test>;
    static constexpr const glsl_file* helpers[] = {&fold_groups_glsl};
    static constexpr number takes[] = {
        {"angle", 0, 1, 1,
         "1: a front surface below the horizon settles a tap, the angle skip; 0: it does not"}};
    static constexpr setting reads[] = {
        {"front_reach", &parameters::front_reach, 0.3f, 0, 1,
         "a front surface nearer to the receiver than this settles a tap, radii"},
    };
    static constexpr part description{
        .kind = role::fold,
        .name = "front_first",
        .summary = "looks at the front surface first, and behind it only where that may matter",
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
