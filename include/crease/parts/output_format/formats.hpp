// SPDX-License-Identifier: MIT
#pragma once

#include <crease/compose/part.hpp>

namespace crease {

/// Visibility in the bytes of a texel, in all four of them.
CREASE_TRAIT(four_bytes, output_format, "visibility must be stored in four bytes, and it is not");

/// Visibility as a 32-bit number.
CREASE_TRAIT(real_number, output_format, "visibility must be stored as a real number, and it is not");

/// The format that the part of the role gives the image of visibility.
constexpr void shape_visibility(resource& own, const shape_of& effect) {
    if (effect.offers(&four_bytes::value))
        own.texels = format::rgba8_unorm;
    if (effect.offers(&real_number::value))
        own.texels = format::r32_float;
}

}
