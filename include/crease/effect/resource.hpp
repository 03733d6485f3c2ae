// SPDX-License-Identifier: MIT
#pragma once

#include <crease/effect/access.hpp>
#include <crease/effect/array_view.hpp>
#include <crease/effect/extent.hpp>
#include <crease/effect/format.hpp>

#include <cstdint>
#include <string_view>

namespace crease {

/// What a resource is made of.
enum class resource_kind : unsigned char {
    image,
    buffer, ///< a storage buffer: an array of `element`
    block   ///< the uniform block, `parameters`
};

/// Who fills a resource, and how long its content lives.
enum class lifetime : unsigned char {
    input,     ///< filled by the host before the first pass
    constant,  ///< filled once, with what `resource::fill` gives
    transient, ///< written by a pass, read by later passes of the same frame
    handed_on, ///< of an output's description: what the main pass and filters hand on to the next
    history,   ///< one of two: a pass writes one and reads the other, what the frame before wrote; swapped
               ///< after each frame
    report,    ///< written by a pass, for the host to read back: counters
    output     ///< written by the last pass, for the host
};

struct shape_of;

/// An image, a buffer or the uniform block that passes read or write.
struct resource {
    std::string_view name;                     ///< e.g. "depth"; in GLSL `crease_depth`
    resource_kind kind = resource_kind::image; ///< what it is made of
    format texels = format::none;    ///< of an image; for an input what crease recommends: any format that
                                     ///< samples as float will do
    std::string_view element{};      ///< of a buffer: the GLSL type of its elements, 4, 8 or 16 bytes: "uint"
    lifetime life = lifetime::input; ///< who fills it, and for how long
    extent size{};                   ///< of an image; of a buffer so many elements, times `layers`
    std::string_view meaning{};      ///< of a report that is a counter: what it counts, and what the host
                                     ///< can do where that is not 0; else empty
    unsigned layers = 1;             ///< of an array image; of a buffer elements for each texel
    unsigned levels = 1; ///< of an image: mip levels, fewer where its size has no more; 16: down to one texel
    unsigned samples = 1;                               ///< of a multisampled image
    bool arrayed = false;                               ///< an array image, also where it has one layer
    bool centred = false;                               ///< all samples of a texel lie at its centre
    array_view<const std::string_view> further_names{}; ///< where each camera has its own, of the size of its
                                                        ///< picture: names of those beside the picture's
    access read = access::sample;   ///< how passes read it: by a sampler, or texel by texel (load)
    std::string_view previous_of{}; ///< of a history that is read: names the resource that passes write; this
                                    ///< one holds what that held after the frame before
    bool cleared = false;           ///< whether it holds `clear` before the first pass of each frame
    std::uint32_t clear = 0;        ///< bits of each component
    void (*fill)(array_view<std::uint32_t> texels) = nullptr; ///< of a constant: its texels, row after row
    void (*shape)(resource& own, const shape_of& effect) =
        nullptr; ///< in a part's description: sets size, layers, levels, samples, format or fill from numbers
    std::string_view content{}; ///< of an input: what the host gives, such as "device_depth" or
                                ///< "packed_view_normals": the words of docs/host.md
};

}
