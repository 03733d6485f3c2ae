// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/depth/fragment_surfaces.hpp>
#include <crease/parts/storage/captures.hpp>

namespace crease {

inline constexpr glsl_file layer_array_glsl{
    "depth/layer_array.glsl",
#include <crease/depth/layer_array.glsl>
};

inline constexpr glsl_file layer_array_draw_glsl{
    "depth/layer_array_draw.glsl",
#include <crease/depth/layer_array_draw.glsl>
};

struct layer_array_part {
    static constexpr number takes[] = {fragment_layers_number, capture_places[0], capture_places[1],
                                       capture_places[2]};
    static constexpr resource owns[] = {fragment_layers,   fragments_beyond_layers, fragment_surfaces,
                                        packed_layers,     packed_opacities,        layer_surfaces,
                                        compressed_layers, compressed_normals};
    static constexpr const glsl_file* drawing[] = {&capture_fragment_glsl, &layer_array_draw_glsl,
                                                   &fragment_key_glsl, &fragments_glsl};
    static constexpr std::string_view drawn[] = {"fragment_layers", "fragments_beyond_layers"};
    static constexpr step passes[] = {
        {.name = "capture_layers",
         .files = drawing,
         .widened = {&layers_with_opacity::value, captures_visible_fragments},
         .kind = step_kind::geometry,
         .writes = drawn,
         .how = access::modify},
        capture_surfaces("capture_surfaces", captures_surfaces<&kept_key_glsl>),
        pack_kept_fragments(packs_sorted_fragments<&kept_key_glsl>, packs_sorted_surfaces<&kept_key_glsl>)};
    static constexpr const glsl_file* files[] = {&layer_array_glsl, &sided_layers_glsl, &packed_layers_glsl};
    static constexpr part description{
        .kind = role::depth_source,
        .name = "layer_array",
        .summary = "the nearest layers of each texel, exactly, in an array image",
        .source = "a-buffer-ssao 2013, IV.C, with layers that stay sorted",
        .files = files,
        .widened = kept_sources_widened,
        .numbers = takes,
        .resources = owns,
        .steps = passes,
        .offers = traits<depth_layers, sorted_layers, layers_behind_front, layers_with_opacity,
                         layers_with_normals, layers_in_strips>::list,
    };
};

/// Depth source: the `Layers` nearest fragments of each texel, front and back faces told apart, in an array
/// image that an atomic minimum keeps sorted. What is farther is counted. Where layers are needed with their
/// opacity, a second geometry pass, `capture_surfaces`, which must meet the same fragments, keeps their
/// colours and normals. The other numbers place its bindings and constants among those of the host's geometry
/// pass.
template <int Layers = 8, int Set = 0, int FirstBinding = 0, int FirstConstant = 0>
struct layer_array : layer_array_part {
    static constexpr int numbers[] = {Layers, Set, FirstBinding, FirstConstant};
};

}
