// SPDX-License-Identifier: MIT
#pragma once

#include <crease/fold/front_first.hpp>

namespace crease {

/// For estimators whose falloff ends at the radius: crease_may_occlude of `front_test`.
inline constexpr glsl_file reach_glsl{
    "estimator/reach.glsl",
#include <crease/estimator/reach.glsl>
};

}
