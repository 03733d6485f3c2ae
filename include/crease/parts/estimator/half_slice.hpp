// SPDX-License-Identifier: MIT
#pragma once

#include <crease/compose/part.hpp>

namespace crease {

/// The half slice of a direction, which estimators by slices share.
inline constexpr glsl_file half_slice_glsl{
    "estimator/half_slice.glsl",
#include <crease/estimator/half_slice.glsl>
};

}
