// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string_view>

namespace crease {

/// What a part does in an effect. Parts are searched, and their passes run, in this order.
enum class role : unsigned char {
    projection,        ///< view: between texels, view space and device depth
    depth_encoding,    ///< view: what the depth image holds
    normals,           ///< view: where the receiver's normal comes from
    noise,             ///< two numbers per pixel, by which a sampler differs from pixel to pixel
    further_views,     ///< view: cameras beside that of the picture
    coverage,          ///< which samples of a texel keep a fragment
    layer_storage,     ///< what keeps the layers that a geometry pass captures
    scan,              ///< how the sums of a line of a table are made, of those of its pieces
    layer_compression, ///< which of the layers of a depth source taps find
    depth_source,      ///< what may be there: the layers that a tap finds
    resolutions,       ///< in which resolutions of the picture the layers of taps are found, where in several
    sampler,           ///< where to look: proposes taps around the receiver
    estimator,         ///< what it means: how much a layer occludes the receiver
    layer_traversal,   ///< which layers of a tap are fetched, and when
    receivers,         ///< whose visibility a pixel asks for
    output,            ///< what leaves the effect beside visibility
    output_format,     ///< of the image of visibility
    filter,            ///< passes over the result: denoising, upsampling
    image_reads,       ///< how passes read what passes write
    stage,             ///< what a pass runs as
    dialect            ///< which GLSL it is written in
};

/// How many roles there are.
inline constexpr std::size_t role_count = static_cast<std::size_t>(role::dialect) + 1;

/// The role in words, as in "layer traversal".
constexpr std::string_view name_of(role r) {
    constexpr std::string_view names[] = {"projection",
                                          "depth encoding",
                                          "normals",
                                          "noise",
                                          "further views",
                                          "coverage",
                                          "layer storage",
                                          "scan",
                                          "layer compression",
                                          "depth source",
                                          "resolutions",
                                          "sampler",
                                          "estimator",
                                          "layer traversal",
                                          "receivers",
                                          "output",
                                          "output format",
                                          "filter",
                                          "image reads",
                                          "stage",
                                          "dialect"};
    return names[static_cast<unsigned>(r)];
}

}
