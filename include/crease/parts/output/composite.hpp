// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/compression/nodes.hpp>
#include <crease/parts/output/outputs.hpp>
#include <crease/parts/receivers/surfaces.hpp>

namespace crease {

inline constexpr glsl_file composite_glsl{
    "output/composite.glsl",
#include <crease/output/composite.glsl>
};

inline constexpr glsl_file encoding_composite_glsl{
    "encoding/composite.glsl",
#include <crease/encoding/composite.glsl>
};

/// The blended layers: linear colour times the opacity, and the opacity; 0 where there is background.
inline constexpr resource color_image{
    .name = "color", .texels = format::rgba16_float, .life = lifetime::output, .read = access::load};

struct composite_part {
    using needs = traits<layers_with_opacity, layers_alone, blended_layers, all_surfaces>;
    static constexpr number takes[] = {
        {"separated", 0, 1, 0,
         "0: each layer's colour is darkened by its own visibility, then blended; 1: the blended colours are "
         "darkened by the blended visibility, which filters may smooth"}};
    static constexpr const glsl_file* files[] = {&encoding_visibility_glsl, &encoding_composite_glsl,
                                                 &composite_glsl};
    static constexpr resource images[] = {between_image(format::rgba32_uint), visibility_image, color_image};
    static constexpr part description{
        .kind = role::output,
        .name = "composite",
        .summary = "visibility, and the colours of all layers, blended in order and darkened by it",
        .source = "a-buffer-ssao 2013, III",
        .files = files,
        .numbers = takes,
        .resources = images,
        .needs = needs::list,
        .offers = traits<handed_on_normals>::list,
    };
};

/// Output: visibility, and the image "color": the layers of each pixel blended in order, darkened by their
/// visibility. Integrated, filters change the visibility alone; where `Separated` is 1 the colours follow it.
template <int Separated = 0>
struct composite : composite_part {
    static constexpr int numbers[] = {Separated};
};

}
