// SPDX-License-Identifier: MIT
#pragma once

#include <crease/compose/trait.hpp>
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

/// `normal` in crease_result, which is handed on where a filter needs it.
CREASE_TRAIT(handed_on_normals, output, "the filter weighs by normals, and the output hands on none");

/// Results that a filter may take the mean of for pixels between theirs.
CREASE_TRAIT(any_resolution, output,
             "the filter makes the picture larger, and the output blends colours, which have a pixel each");

/// The format that filters give what passes hand on: wide enough for the normal too, where one needs it.
constexpr void shape_between(resource& own, const shape_of& effect) {
    if (effect.needs(&handed_on_normals::value))
        own.texels = own.texels == format::r32_uint ? format::rg32_uint : format::rgba32_uint;
}

/// What a pass hands on to a filter, in texels of the format that does without the normal.
constexpr resource between_image(format texels) {
    return {.name = "between",
            .texels = texels,
            .life = lifetime::handed_on,
            .read = access::load,
            .shape = shape_between};
}

}
