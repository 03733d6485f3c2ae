// SPDX-License-Identifier: MIT
#pragma once

#include <crease/compose/part.hpp>

namespace crease {

/// What estimators with horizons share of open directions.
inline constexpr glsl_file open_horizon_glsl{
    "estimator/open_horizon.glsl",
#include <crease/estimator/open_horizon.glsl>
};

}
