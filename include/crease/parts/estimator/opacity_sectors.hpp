// SPDX-License-Identifier: MIT
#pragma once

#include <crease/compose/part.hpp>

namespace crease {

/// The sectors in which a layer of an opacity counts, which bitmasks share.
inline constexpr glsl_file opacity_sectors_glsl{
    "estimator/opacity_sectors.glsl",
#include <crease/estimator/opacity_sectors.glsl>
};

}
