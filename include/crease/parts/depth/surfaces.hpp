// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/depth/fragments.hpp>
#include <crease/parts/output/octahedron.hpp>

#include <string_view>

namespace crease {

// Sources where layers_with_opacity is needed: what they share beside sorting and fetching their own
// fragments, `crease_fragments crease_sorted_fragments(ivec2 texel)` and `uvec2 crease_fragment_surface(ivec2
// texel, uint place)`.

inline constexpr glsl_file encoding_surface_normal_glsl{
    "encoding/surface_normal.glsl",
#include <crease/encoding/surface_normal.glsl>
};

inline constexpr glsl_file surface_fragments_glsl{
    "depth/surface_fragments.glsl",
#include <crease/depth/surface_fragments.glsl>
};

inline constexpr glsl_file order_equal_fragments_glsl{
    "depth/order_equal_fragments.glsl",
#include <crease/depth/order_equal_fragments.glsl>
};

inline constexpr glsl_file pack_surfaces_glsl{
    "depth/pack_surfaces.glsl",
#include <crease/depth/pack_surfaces.glsl>
};

inline constexpr glsl_file layers_with_opacity_glsl{
    "depth/layers_with_opacity.glsl",
#include <crease/depth/layers_with_opacity.glsl>
};

inline constexpr glsl_file surface_layers_glsl{
    "depth/surface_layers.glsl",
#include <crease/depth/surface_layers.glsl>
};

inline constexpr glsl_file pack_whole_lists_glsl{
    "depth/pack_whole_lists.glsl",
#include <crease/depth/pack_whole_lists.glsl>
};

/// As many as of the groups of depths.
constexpr void shape_packed_opacities(resource& own, const shape_of& effect) {
    own.layers = static_cast<unsigned>((effect.own.numbers[0] + 3) / 4);
}

/// The opacities of the packed layers, a byte each.
inline constexpr resource packed_opacities{.name = "packed_opacities",
                                           .texels = format::r32_uint,
                                           .life = lifetime::transient,
                                           .size = {.guarded = true},
                                           .arrayed = true,
                                           .read = access::load,
                                           .shape = shape_packed_opacities};

/// What receivers read of a layer: depth, which is negative of back faces, colour with opacity, and normal.
inline constexpr resource layer_surfaces{.name = "layer_surfaces",
                                         .texels = format::rgba32_uint,
                                         .life = lifetime::transient,
                                         .size = {.guarded = true},
                                         .arrayed = true,
                                         .read = access::load,
                                         .shape = shape_fragment_layers};

/// As many layers as the nodes of the layer compression take, four in each.
constexpr void shape_compressed_layers(resource& own, const shape_of& effect) {
    own.layers = static_cast<unsigned>((effect.number_of(role::layer_compression, "nodes") + 3) / 4);
}

/// Two layers for each four nodes, of which the first normal and a part of the second are elsewhere.
constexpr void shape_compressed_normals(resource& own, const shape_of& effect) {
    shape_compressed_layers(own, effect);
    own.layers *= 2;
}

/// What a layer compression keeps of a texel: depths and opacities in groups of four, and where
/// layers_with_normals is needed, with `compressed_normals`, their normals.
inline constexpr resource compressed_layers{.name = "compressed_layers",
                                            .texels = format::rgba32_uint,
                                            .life = lifetime::transient,
                                            .size = {.guarded = true},
                                            .arrayed = true,
                                            .read = access::load,
                                            .shape = shape_compressed_layers};
/// What receivers read beside these.
inline constexpr resource compressed_normals{.name = "compressed_normals",
                                             .texels = format::r32_uint,
                                             .life = lifetime::transient,
                                             .size = {.guarded = true},
                                             .arrayed = true,
                                             .read = access::load,
                                             .shape = shape_compressed_normals};

/// What the packing pass of a source fills, with or without surfaces, compressed or not.
inline constexpr std::string_view fills_surfaces_counting[] = {
    "packed_layers",     "packed_opacities",   "layer_surfaces",
    "compressed_layers", "compressed_normals", "fragments_beyond_layers"};

/// The same of a source that counts nothing there.
inline constexpr array_view<const std::string_view> fills_surfaces(fills_surfaces_counting,
                                                                   std::size(fills_surfaces_counting) - 1);

/// The GLSL of such a source for all passes.
inline constexpr const glsl_file* surface_files[] = {&layers_with_opacity_glsl, &surface_layers_glsl,
                                                     &pack_whole_lists_glsl, &encoding_surface_normal_glsl,
                                                     &encoding_octahedron_glsl};

/// What stands before the files of a source that packs its layers, with or without opacity.
inline constexpr files_where packed_sources_widened[] = {{&layers_with_opacity::value, surface_files},
                                                         {&layers_in_strips::value, packed_layers_strips}};

}
