// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/depth/surfaces.hpp>
#include <crease/parts/storage/captures.hpp>

namespace crease {

inline constexpr glsl_file linked_lists_glsl{
    "depth/linked_lists.glsl",
#include <crease/depth/linked_lists.glsl>
};

inline constexpr glsl_file linked_lists_draw_glsl{
    "depth/linked_lists_draw.glsl",
#include <crease/depth/linked_lists_draw.glsl>
};

inline constexpr glsl_file linked_lists_sort_glsl{
    "depth/linked_lists_sort.glsl",
#include <crease/depth/linked_lists_sort.glsl>
};

inline constexpr glsl_file linked_surfaces_draw_glsl{
    "depth/linked_surfaces_draw.glsl",
#include <crease/depth/linked_surfaces_draw.glsl>
};

inline constexpr glsl_file linked_surfaces_sort_glsl{
    "depth/linked_surfaces_sort.glsl",
#include <crease/depth/linked_surfaces_sort.glsl>
};

struct linked_lists_part {
    static constexpr number takes[] = {fragment_layers_number, pool_nodes_number, capture_places[0],
                                       capture_places[1], capture_places[2]};
    static constexpr void shape_nodes(resource& own, const shape_of& effect) {
        shape_pool(own, effect);
        if (effect.needs(&layers_with_opacity::value))
            own.element = "uvec4";
    }
    static constexpr void shape_heads(resource& own, const shape_of& effect) {
        if (effect.needs(&layers_with_opacity::value))
            own.layers = 6;
    }
    static constexpr resource owns[] = {
        {.name = "list_heads", // the nearest fragment of a texel, and the first node of the others
         .texels = format::r32_uint,
         .life = lifetime::transient,
         .size = {.guarded = true},
         .layers = 2,
         .arrayed = true,
         .read = access::load,
         .cleared = true,
         .clear = ~0u,
         .shape = shape_heads},
        {.name = "list_nodes",
         .kind = resource_kind::buffer,
         .element = "uvec2",
         .life = lifetime::transient,
         .size = {.guarded = true},
         .shape = shape_nodes},
        {.name = "node_count",
         .kind = resource_kind::buffer,
         .element = "uint",
         .life = lifetime::transient,
         .size = {.fixed_width = 1, .fixed_height = 1},
         .cleared = true},
        fragments_beyond_pool,
        fragments_beyond_layers,
        packed_layers,
        packed_opacities,
        layer_surfaces,
        compressed_layers,
        compressed_normals};
    static constexpr const glsl_file* drawing_surfaces[] = {
        &linked_surfaces_draw_glsl, &encoding_surface_normal_glsl, &encoding_octahedron_glsl};
    static constexpr const glsl_file* packing_surfaces[] = {&pack_surfaces_glsl, &order_equal_fragments_glsl,
                                                            &linked_surfaces_sort_glsl,
                                                            &surface_fragments_glsl};
    static constexpr const glsl_file* drawing[] = {&linked_lists_draw_glsl, &fragment_key_glsl,
                                                   &fragments_glsl};
    static constexpr const glsl_file* packing[] = {&pack_fragments_glsl, &linked_lists_sort_glsl,
                                                   &insert_fragment_glsl, &fragments_glsl};
    static constexpr std::string_view drawn[] = {"list_heads", "list_nodes", "node_count",
                                                 "fragments_beyond_pool"};
    static constexpr step passes[] = {{.name = "capture_layers",
                                       .files = drawing,
                                       .widened = {&layers_with_opacity::value, drawing_surfaces},
                                       .kind = step_kind::geometry,
                                       .writes = drawn,
                                       .how = access::modify},
                                      {.name = "pack_layers",
                                       .files = packing,
                                       .widened = {&layers_with_opacity::value, packing_surfaces},
                                       .kind = step_kind::texels,
                                       .writes = fills_surfaces_counting,
                                       .how = access::modify}};
    static constexpr const glsl_file* files[] = {&linked_lists_glsl, &sided_layers_glsl, &packed_layers_glsl};
    static constexpr part description{
        .kind = role::depth_source,
        .name = "linked_lists",
        .summary = "all fragments in lists of a bounded pool, of which the nearest of each texel are sorted",
        .source = "a-buffer-ssao 2013, IV.A",
        .files = files,
        .widened = packed_sources_widened,
        .numbers = takes,
        .resources = owns,
        .steps = passes,
        .offers = traits<depth_layers, sorted_layers, layers_behind_front, layers_with_opacity,
                         layers_with_normals, layers_in_strips>::list,
    };
};

/// Depth source: all fragments, front and back faces told apart, in a linked list for each texel, of which
/// the `Layers` nearest are sorted for the taps. The nodes of all lists come from one pool of `Nodes` for
/// each texel; the nearest fragment of a texel needs none, or with opacity only where the pool is full. What
/// finds the pool full, and what is farther than the layers, is counted. The other numbers place its bindings
/// and constants among those of the host's geometry pass.
template <int Layers = 8, int Nodes = 8, int Set = 0, int FirstBinding = 0, int FirstConstant = 0>
struct linked_lists : linked_lists_part {
    static constexpr int numbers[] = {Layers, Nodes, Set, FirstBinding, FirstConstant};
};

}
