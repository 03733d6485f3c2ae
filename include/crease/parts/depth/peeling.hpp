// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/depth/fragment_surfaces.hpp>
#include <crease/parts/storage/captures.hpp>

namespace crease {

inline constexpr glsl_file peel_layer_glsl{
    "depth/peel_layer.glsl",
#include <crease/depth/peel_layer.glsl>
};

/// What depth sources share that draw the geometry again and again, and each time peel what was kept before.
namespace peeling {

/// How often the geometry was drawn before: `crease_peeling_index`.
template <int Index>
inline constexpr step_constant index[] = {{"index", Index, "peeling"}};

/// A geometry pass that fills one layer or more.
/// @param from  number of layers from which on there is such a pass
template <int Index>
constexpr step peel(std::string_view name, array_view<const glsl_file* const> drawing, int from = Index + 1) {
    return {.name = name,
            .files = drawing,
            .widened = {&layers_with_opacity::value, captures_visible_fragments},
            .kind = step_kind::geometry,
            .constants = index<Index>,
            .writes = fills_fragment_layers,
            .how = access::modify,
            .from = from};
}

/// Where a file says what lies behind a layer.
template <const glsl_file* Behind>
inline constexpr const glsl_file* drawing[] = {&capture_fragment_glsl, &peel_layer_glsl, Behind,
                                               &fragment_key_glsl, &fragments_glsl};

/// The layers one by one, the nearest first.
template <const glsl_file* Behind>
inline constexpr step nearest_first[] = {
    peel<0>("peel_layer_0", drawing<Behind>),
    peel<1>("peel_layer_1", drawing<Behind>),
    peel<2>("peel_layer_2", drawing<Behind>),
    peel<3>("peel_layer_3", drawing<Behind>),
    peel<4>("peel_layer_4", drawing<Behind>),
    peel<5>("peel_layer_5", drawing<Behind>),
    peel<6>("peel_layer_6", drawing<Behind>),
    peel<7>("peel_layer_7", drawing<Behind>),
    capture_surfaces("capture_surfaces", captures_surfaces<&kept_key_glsl>),
    pack_kept_fragments(packs_sorted_fragments<&kept_key_glsl>, packs_sorted_surfaces<&kept_key_glsl>)};

/// What they fill.
inline constexpr resource resources[] = {fragment_layers,   fragment_surfaces, packed_layers,
                                         packed_opacities,  layer_surfaces,    compressed_layers,
                                         compressed_normals};
/// What they offer.
using offered = traits<depth_layers, sorted_layers, layers_behind_front, layers_with_opacity,
                       layers_with_normals, layers_in_strips>;

}

}
