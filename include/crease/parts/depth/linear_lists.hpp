// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/depth/surfaces.hpp>
#include <crease/parts/storage/captures.hpp>

namespace crease {

inline constexpr glsl_file linear_lists_glsl{
    "depth/linear_lists.glsl",
#include <crease/depth/linear_lists.glsl>
};

inline constexpr glsl_file linear_lists_count_glsl{
    "depth/linear_lists_count.glsl",
#include <crease/depth/linear_lists_count.glsl>
};

inline constexpr glsl_file linear_lists_columns_glsl{
    "depth/linear_lists_columns.glsl",
#include <crease/depth/linear_lists_columns.glsl>
};

inline constexpr glsl_file linear_lists_row_glsl{
    "depth/linear_lists_row.glsl",
#include <crease/depth/linear_lists_row.glsl>
};

inline constexpr glsl_file count_before_glsl{
    "depth/count_before.glsl",
#include <crease/depth/count_before.glsl>
};

inline constexpr glsl_file linear_lists_range_glsl{
    "depth/linear_lists_range.glsl",
#include <crease/depth/linear_lists_range.glsl>
};

inline constexpr glsl_file linear_lists_next_glsl{
    "depth/linear_lists_next.glsl",
#include <crease/depth/linear_lists_next.glsl>
};

inline constexpr glsl_file linear_lists_draw_glsl{
    "depth/linear_lists_draw.glsl",
#include <crease/depth/linear_lists_draw.glsl>
};

inline constexpr glsl_file linear_lists_sort_glsl{
    "depth/linear_lists_sort.glsl",
#include <crease/depth/linear_lists_sort.glsl>
};

inline constexpr glsl_file linear_surfaces_count_glsl{
    "depth/linear_surfaces_count.glsl",
#include <crease/depth/linear_surfaces_count.glsl>
};

inline constexpr glsl_file linear_surfaces_draw_glsl{
    "depth/linear_surfaces_draw.glsl",
#include <crease/depth/linear_surfaces_draw.glsl>
};

inline constexpr glsl_file linear_surfaces_range_glsl{
    "depth/linear_surfaces_range.glsl",
#include <crease/depth/linear_surfaces_range.glsl>
};

inline constexpr glsl_file linear_surfaces_sort_glsl{
    "depth/linear_surfaces_sort.glsl",
#include <crease/depth/linear_surfaces_sort.glsl>
};

struct linear_lists_part {
    static constexpr number takes[] = {fragment_layers_number, pool_nodes_number, capture_places[0],
                                       capture_places[1], capture_places[2]};
    static constexpr void shape_nodes(resource& own, const shape_of& effect) {
        shape_pool(own, effect);
        if (effect.needs(&layers_with_opacity::value)) {
            own.element = "uvec4";
            ++own.layers;
        }
    }
    static constexpr void shape_places(resource& own, const shape_of& effect) {
        if (effect.needs(&layers_with_opacity::value))
            own.layers = 3;
    }
    static constexpr resource owns[] = {{.name = "nearest_fragments",
                                         .texels = format::r32_uint,
                                         .life = lifetime::transient,
                                         .size = {.guarded = true},
                                         .read = access::load,
                                         .cleared = true,
                                         .clear = ~0u},
                                        // How many fragments are counted, and then where the list ends; how
                                        // many are stored; with opacity whether the nearest is.
                                        {.name = "list_places",
                                         .texels = format::r32_uint,
                                         .life = lifetime::transient,
                                         .size = {.guarded = true},
                                         .layers = 2,
                                         .arrayed = true,
                                         .read = access::load,
                                         .cleared = true,
                                         .shape = shape_places},
                                        {.name = "column_starts",
                                         .kind = resource_kind::buffer,
                                         .element = "uint",
                                         .life = lifetime::transient,
                                         .size = {.guarded = true, .fixed_height = 1}},
                                        {.name = "list_nodes",
                                         .kind = resource_kind::buffer,
                                         .element = "uint",
                                         .life = lifetime::transient,
                                         .size = {.guarded = true},
                                         .shape = shape_nodes},
                                        fragments_beyond_pool,
                                        fragments_beyond_layers,
                                        packed_layers,
                                        packed_opacities,
                                        layer_surfaces,
                                        compressed_layers,
                                        compressed_normals};
    static constexpr const glsl_file* counting[] = {&linear_lists_count_glsl};
    static constexpr const glsl_file* column_files[] = {&linear_lists_columns_glsl, &count_before_glsl};
    static constexpr const glsl_file* row_files[] = {&linear_lists_row_glsl, &count_before_glsl};
    static constexpr const glsl_file* drawing[] = {&linear_lists_draw_glsl, &linear_lists_next_glsl,
                                                   &linear_lists_range_glsl, &fragment_key_glsl,
                                                   &fragments_glsl};
    static constexpr const glsl_file* packing[] = {&pack_fragments_glsl, &linear_lists_sort_glsl,
                                                   &linear_lists_range_glsl, &insert_fragment_glsl,
                                                   &fragments_glsl};
    static constexpr const glsl_file* counting_surfaces[] = {&linear_surfaces_count_glsl, &fragment_key_glsl};
    static constexpr const glsl_file* drawing_surfaces[] = {
        &linear_surfaces_draw_glsl, &linear_lists_next_glsl, &linear_surfaces_range_glsl,
        &encoding_surface_normal_glsl, &encoding_octahedron_glsl};
    static constexpr const glsl_file* packing_surfaces[] = {
        &pack_surfaces_glsl, &order_equal_fragments_glsl, &linear_surfaces_sort_glsl,
        &linear_surfaces_range_glsl, &surface_fragments_glsl};
    static constexpr std::string_view counted[] = {"list_places", "nearest_fragments"};
    static constexpr std::string_view places[] = {"list_places"};
    static constexpr std::string_view starts[] = {"column_starts"};
    static constexpr std::string_view drawn[] = {"nearest_fragments", "list_places", "list_nodes",
                                                 "fragments_beyond_pool"};
    static constexpr role required[] = {role::scan};
    static constexpr step passes[] = {{.name = "count_fragments",
                                       .files = counting,
                                       .widened = {&layers_with_opacity::value, counting_surfaces},
                                       .kind = step_kind::geometry,
                                       .writes = counted,
                                       .how = access::modify},
                                      {.name = "sum_columns",
                                       .files = column_files,
                                       .kind = step_kind::columns,
                                       .writes = places,
                                       .how = access::modify},
                                      {.name = "sum_row",
                                       .files = row_files,
                                       .kind = step_kind::rows,
                                       .writes = starts,
                                       .group_width = 256,
                                       .group_height = 1},
                                      {.name = "capture_layers",
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
    static constexpr const glsl_file* files[] = {&linear_lists_glsl, &sided_layers_glsl, &packed_layers_glsl};
    static constexpr part description{
        .kind = role::depth_source,
        .name = "linear_lists",
        .summary = "all fragments in a bounded pool, those of a texel side by side; the nearest are sorted",
        .source = "a-buffer-ssao 2013, IV.B",
        .files = files,
        .widened = packed_sources_widened,
        .numbers = takes,
        .resources = owns,
        .steps = passes,
        .offers = traits<depth_layers, sorted_layers, layers_behind_front, layers_with_opacity,
                         layers_with_normals, layers_in_strips>::list,
        .required_roles = required,
    };
};

/// Depth source: all fragments, front and back faces told apart, side by side in a list for each texel, of
/// which the `Layers` nearest are sorted for the taps. The host draws its geometry twice: the passes
/// `count_fragments` and `capture_layers` must meet the same fragments, and between them prefix sums place
/// the lists in a pool of `Nodes` for each texel, beside which the nearest fragment of each has a place. What
/// finds the pool full, those of the right columns first, and what is farther than the layers, is counted.
/// The other numbers place the bindings and constants of both passes among those of the host's geometry pass.
template <int Layers = 8, int Nodes = 8, int Set = 0, int FirstBinding = 0, int FirstConstant = 0>
struct linear_lists : linear_lists_part {
    static constexpr int numbers[] = {Layers, Nodes, Set, FirstBinding, FirstConstant};
};

}
