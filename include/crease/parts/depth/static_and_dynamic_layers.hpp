// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/depth/fragments.hpp>
#include <crease/parts/storage/captures.hpp>

namespace crease {

inline constexpr glsl_file static_and_dynamic_layers_glsl{
    "depth/static_and_dynamic_layers.glsl",
#include <crease/depth/static_and_dynamic_layers.glsl>
};

inline constexpr glsl_file static_and_dynamic_layers_draw_glsl{
    "depth/static_and_dynamic_layers_draw.glsl",
#include <crease/depth/static_and_dynamic_layers_draw.glsl>
};

inline constexpr glsl_file static_and_dynamic_layers_sort_glsl{
    "depth/static_and_dynamic_layers_sort.glsl",
#include <crease/depth/static_and_dynamic_layers_sort.glsl>
};

/// A resource of which no number of the part says how many layers it has.
constexpr resource shaped_by(resource own, void (*shape)(resource& own, const shape_of& effect)) {
    own.shape = shape;
    return own;
}

struct static_and_dynamic_layers_part {
    static constexpr number takes[] = {capture_places[0], capture_places[1], capture_places[2]};
    static constexpr void shape_fragments(resource& own, const shape_of&) { own.layers = 2; }
    static constexpr void shape_packed(resource& own, const shape_of&) { own.texels = format::rg32_float; }
    static constexpr resource owns[] = {shaped_by(fragment_layers, shape_fragments),
                                        shaped_by(packed_layers, shape_packed)};
    static constexpr const glsl_file* drawing[] = {&capture_fragment_glsl,
                                                   &static_and_dynamic_layers_draw_glsl, &fragment_key_glsl};
    static constexpr const glsl_file* packing[] = {&pack_fragments_glsl, &static_and_dynamic_layers_sort_glsl,
                                                   &fragments_glsl};
    static constexpr step_constant of_static[] = {{"index", 0}};
    static constexpr step_constant of_dynamic[] = {{"index", 1}};
    static constexpr step passes[] = {
        {.name = "capture_static",
         .files = drawing,
         .kind = step_kind::geometry,
         .constants = of_static,
         .writes = fills_fragment_layers,
         .how = access::modify},
        {.name = "capture_dynamic",
         .files = drawing,
         .kind = step_kind::geometry,
         .constants = of_dynamic,
         .writes = fills_fragment_layers,
         .how = access::modify},
        {.name = "pack_layers", .files = packing, .kind = step_kind::texels, .writes = fills_packed_layers}};
    static constexpr const glsl_file* files[] = {&static_and_dynamic_layers_glsl, &sided_layers_glsl,
                                                 &packed_layers_glsl};
    static constexpr part description{
        .kind = role::depth_source,
        .name = "static_and_dynamic_layers",
        .summary = "the first layer of static and the first of dynamic geometry",
        .source = "HBAO+, NVIDIA; stochastic-depth-ao 2020, 3",
        .files = files,
        .widened = packed_layers_widened,
        .numbers = takes,
        .resources = owns,
        .steps = passes,
        .offers = traits<depth_layers, sorted_layers, layers_behind_front, layers_in_strips>::list,
    };
};

/// Depth source: two layers, the nearest fragment of what the host draws in the geometry pass
/// `capture_static` and the nearest of what it draws in `capture_dynamic`, each drawn once. Where they are
/// equal there is one. The numbers place its bindings and constants among those of the host's geometry pass.
template <int Set = 0, int FirstBinding = 0, int FirstConstant = 0>
struct static_and_dynamic_layers : static_and_dynamic_layers_part {
    static constexpr int numbers[] = {Set, FirstBinding, FirstConstant};
};

}
