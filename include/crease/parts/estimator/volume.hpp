// SPDX-License-Identifier: MIT
#pragma once

#include <crease/compose/part.hpp>

namespace crease {

/// What estimators of volume share.
inline constexpr glsl_file volume_glsl{
    "estimator/volume.glsl",
#include <crease/estimator/volume.glsl>
};

}
