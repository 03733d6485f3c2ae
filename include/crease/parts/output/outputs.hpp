// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/output_format/formats.hpp>

namespace crease {

// How a result is kept in the texels of an image: crease_encode_<name> of what leaves the effect, and
// crease_encode_between and crease_decode of what a pass hands on to a filter.

inline constexpr glsl_file encoding_visibility_glsl{
    "encoding/visibility.glsl",
#include <crease/encoding/visibility.glsl>
};

inline constexpr glsl_file encoding_visibility_depth_glsl{
    "encoding/visibility_depth.glsl",
#include <crease/encoding/visibility_depth.glsl>
};

/// Visibility in [0, 1]: 1 open, 0 closed, background too.
inline constexpr resource visibility_image{.name = "visibility",
                                           .texels = format::r8_unorm,
                                           .life = lifetime::output,
                                           .read = access::load,
                                           .shape = shape_visibility};

/// What a pass hands on to a filter, in texels of a format.
constexpr resource between_image(format texels) {
    return {.name = "between", .texels = texels, .life = lifetime::handed_on, .read = access::load};
}

}
