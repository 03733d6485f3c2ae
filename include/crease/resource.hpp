// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace crease {

/// Texel formats, named as in Vulkan.
enum class format : unsigned char { none, r8_unorm, r32_uint, r32_float, rgba16_float, d32_float };

/// The format's name in the layout of a GLSL storage image.
constexpr std::string_view glsl_format(format f) {
    constexpr std::string_view names[] = {"", "r8", "r32ui", "r32f", "rgba16f", ""};
    return names[static_cast<unsigned>(f)];
}

/// Who fills a resource, and how long its content lives.
enum class lifetime : unsigned char {
    input,     ///< filled by the host before the first pass
    transient, ///< written by one pass, read by later passes of the same frame
    history,   ///< written in one frame, read in the next
    output     ///< written by the last pass, for the host
};

/// How large an image is: the resolution of the picture divided by `divisor`, rounded up, on each axis.
struct extent {
    unsigned divisor = 1;

    constexpr unsigned of(unsigned texels) const { return (texels + divisor - 1) / divisor; }
    constexpr bool operator==(const extent&) const = default;
};

/// An image or a uniform block that passes read or write.
struct resource {
    std::string_view name; ///< e.g. "depth"; in GLSL `crease_depth`
    format texels =
        format::none; ///< of an image that crease writes; for an input what crease recommends: any
                      ///< format that samples as float will do. `none`: the block of parameters
    lifetime life = lifetime::input;
    extent size{};
    unsigned layers = 1;  ///< of an array image
    unsigned samples = 1; ///< of a multisampled image
};

}
