// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace crease {

/// Texel formats, named as in Vulkan.
enum class format : unsigned char {
    none,
    r8_unorm,
    rgba8_unorm,
    r32_uint,
    rg32_uint,
    rgba32_uint,
    r32_float,
    rg32_float,
    rgba16_float,
    rgba32_float,
    d32_float
};

/// What GLSL and a device must know of a format.
struct format_facts {
    std::string_view name;      ///< as in `format`
    std::string_view glsl;      ///< in the layout of a storage image; empty where there are none
    format stored_by_all;       ///< itself, or the next that every device can store
    bool whole_numbers = false; ///< texels are unsigned integers
    bool extended = false;      ///< storing needs shaderStorageImageExtendedFormats
};

/// In the order of `format`.
inline constexpr format_facts facts_of_formats[] = {
    {"none", "", format::none},
    {"r8_unorm", "r8", format::rgba8_unorm, false, true},
    {"rgba8_unorm", "rgba8", format::rgba8_unorm},
    {"r32_uint", "r32ui", format::r32_uint, true},
    {"rg32_uint", "rg32ui", format::rgba32_uint, true, true},
    {"rgba32_uint", "rgba32ui", format::rgba32_uint, true},
    {"r32_float", "r32f", format::r32_float},
    {"rg32_float", "rg32f", format::rgba32_float, false, true},
    {"rgba16_float", "rgba16f", format::rgba16_float},
    {"rgba32_float", "rgba32f", format::rgba32_float},
    {"d32_float", "", format::d32_float},
};

/// What GLSL and a device must know of `f`.
constexpr const format_facts& facts_of(format f) {
    return facts_of_formats[static_cast<unsigned>(f)];
}

}
