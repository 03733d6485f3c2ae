// SPDX-License-Identifier: MIT
#pragma once

#include <crease/part.hpp>

namespace crease {

/// What estimators with horizons share of the bent normal.
inline constexpr glsl_file bent_turn_glsl{
    "estimator/bent_turn.glsl",
#include <crease/estimator/bent_turn.glsl>
};

}
