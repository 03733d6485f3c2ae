// SPDX-License-Identifier: MIT
#pragma once

#include <crease/part.hpp>

namespace crease {

inline constexpr glsl_file encoding_visibility_glsl{
    "encoding/visibility.glsl",
#include <crease/encoding/visibility.glsl>
};

inline constexpr glsl_file encoding_visibility_depth_glsl{
    "encoding/visibility_depth.glsl",
#include <crease/encoding/visibility_depth.glsl>
};

/// What leaves an effect: visibility in [0, 1].
inline constexpr encoding visibility_encoding{"visibility", format::r8_unorm, &encoding_visibility_glsl};

/// What a filter reads: visibility and linear depth in one texel.
inline constexpr encoding visibility_depth_encoding{"visibility_depth", format::r32_uint,
                                                    &encoding_visibility_depth_glsl};

}
