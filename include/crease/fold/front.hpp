// SPDX-License-Identifier: MIT
#pragma once

#include <crease/fold/groups.hpp>

namespace crease {

inline constexpr glsl_file fold_front_glsl{
    "fold/front.glsl",
#include <crease/fold/front.glsl>
};

inline constexpr glsl_file front_dropped_glsl{
    "fold/front_dropped.glsl",
#include <crease/fold/front_dropped.glsl>
};

/// A test by which the front layer of a tap settles it: crease_front_settles.
CREASE_TRAIT(front_test, estimator,
             "the fold needs a test of the front surface, which the estimator does not have");

/// What the folds have in common that look at the front surface before the layers behind it.
struct front_part {
    static constexpr number takes[] = {
        {"angle", 0, 1, 1,
         "1: a front surface below the horizon settles a tap, the angle skip; 0: it does not"}};
    static constexpr setting reads[] = {
        {"front_reach", &parameters::front_reach, 0.3f, 0, 1,
         "a front surface nearer to the receiver than this settles a tap, radii"},
    };
};

}
