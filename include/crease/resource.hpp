// SPDX-License-Identifier: MIT
#pragma once

#include <crease/array_view.hpp>

#include <cstdint>
#include <string_view>

namespace crease {

/// Texel formats, named as in Vulkan.
enum class format : unsigned char {
    none,
    r8_unorm,
    rgba8_unorm,
    r32_uint,
    rg32_uint,
    r32_float,
    rg32_float,
    rgba16_float,
    rgba32_float,
    d32_float
};

/// What GLSL and a device must know of a format.
struct format_facts {
    std::string_view name;
    std::string_view glsl;      ///< in the layout of a storage image; empty where there are none
    bool whole_numbers = false; ///< texels are unsigned integers
    bool extended = false;      ///< storing needs shaderStorageImageExtendedFormats
};

inline constexpr format_facts facts_of_formats[] = {
    {"none", ""},
    {"r8_unorm", "r8", false, true},
    {"rgba8_unorm", "rgba8"},
    {"r32_uint", "r32ui", true},
    {"rg32_uint", "rg32ui", true, true},
    {"r32_float", "r32f"},
    {"rg32_float", "rg32f", false, true},
    {"rgba16_float", "rgba16f"},
    {"rgba32_float", "rgba32f"},
    {"d32_float", ""},
};

constexpr const format_facts& facts_of(format f) {
    return facts_of_formats[static_cast<unsigned>(f)];
}

/// How a pass touches a resource.
enum class access : unsigned char {
    uniform,    ///< a std140 block
    sample,     ///< a sampled image, nearest filter, clamped to the edge, one level
    load,       ///< a storage image that is read
    store,      ///< a storage image that is written
    modify,     ///< a storage image that is changed by atomic operations
    attachment, ///< a colour attachment; has no binding, its location is `slot`
    result      ///< the return value of a function; has no binding
};

/// Whether a pass writes what it touches so.
constexpr bool writes(access how) {
    return how != access::uniform && how != access::sample && how != access::load;
}

/// Whether what is touched so has a descriptor.
constexpr bool has_descriptor(access how) {
    return how != access::attachment && how != access::result;
}

/// Who fills a resource, and how long its content lives.
enum class lifetime : unsigned char {
    input,     ///< filled by the host before the first pass
    captured,  ///< filled by the host's geometry pass, through one of the effect's captures
    constant,  ///< filled once, with what `resource::fill` gives
    transient, ///< written by one pass, read by later passes of the same frame
    history,   ///< written in one frame, read in the next
    output     ///< written by the last pass, for the host
};

/// How large an image is: the resolution of the picture divided by `divisor`, rounded up, on each axis; with
/// the guard band around it where it is `guarded`. Or of a fixed size.
struct extent {
    unsigned divisor = 1;
    bool guarded = false;
    unsigned fixed_width = 0, fixed_height = 0; ///< texels; 0: follows the picture

    constexpr unsigned width_of(unsigned picture_width, unsigned guard = 0) const {
        return fixed_width ? fixed_width : of(picture_width, guard);
    }
    constexpr unsigned height_of(unsigned picture_height, unsigned guard = 0) const {
        return fixed_height ? fixed_height : of(picture_height, guard);
    }
    constexpr bool operator==(const extent&) const = default;

private:
    constexpr unsigned of(unsigned texels, unsigned guard) const {
        return (texels + divisor - 1) / divisor + (guarded ? 2 * guard : 0);
    }
};

/// A count that follows a number of the depth source: the number divided by `share`, rounded up.
struct counted {
    int number = -1; ///< index of the depth source's number; -1: the count is fixed
    int share = 1;

    constexpr bool operator==(const counted&) const = default;
};

struct trait;

/// An image or a uniform block that passes read or write.
struct resource {
    std::string_view name; ///< e.g. "depth"; in GLSL `crease_depth`
    format texels =
        format::none; ///< of an image that crease writes; for an input what crease recommends: any
                      ///< format that samples as float will do. `none`: the block of parameters
    lifetime life = lifetime::input;
    extent size{};
    unsigned layers = 1;          ///< of an array image
    unsigned samples = 1;         ///< of a multisampled image
    bool arrayed = false;         ///< an array image, also where it has one layer
    bool centred = false;         ///< all samples of a texel lie at its centre
    access read = access::sample; ///< how passes read it; or load
    std::uint32_t clear = 0; ///< what each component of a captured storage image holds before the capture
    counted layers_by{}, samples_by{};        ///< of a part's description; an effect has the counts
    array_view<const format> texels_of_few{}; ///< of a part's description: the texels where the number of
                                              ///< `layers_by` is 1, 2 and so on; `texels` where it is more
    const trait* texels_by = nullptr; ///< of a part's description: the trait whose extra may say the texels
    int divisor_by = -1; ///< of a part's description: index of the depth source's number that is the divisor
                         ///< of the size; -1: that is fixed
    void (*fill)(array_view<std::uint32_t> texels,
                 unsigned count) = nullptr; ///< of a constant: its texels, row after row
    unsigned count = 0;                     ///< what `fill` takes: the first number of the depth source
};

}
