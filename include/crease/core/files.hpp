// SPDX-License-Identifier: MIT
#pragma once

#include <crease/glsl_file.hpp>

namespace crease {

inline constexpr glsl_file parameters_glsl{
    "core/parameters.glsl",
#include <crease/core/parameters.glsl>
};

inline constexpr glsl_file types_glsl{
    "core/types.glsl",
#include <crease/core/types.glsl>
};

inline constexpr glsl_file visibility_glsl{
    "core/visibility.glsl",
#include <crease/core/visibility.glsl>
};

}
