// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/depth/fragment_surfaces.hpp>
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

inline constexpr glsl_file static_and_dynamic_surfaces_sort_glsl{
    "depth/static_and_dynamic_surfaces_sort.glsl",
#include <crease/depth/static_and_dynamic_surfaces_sort.glsl>
};

inline constexpr glsl_file static_and_dynamic_layers_kept_key_glsl{
    "depth/static_and_dynamic_layers_kept_key.glsl",
#include <crease/depth/static_and_dynamic_layers_kept_key.glsl>
};

/// A resource of two layers, whose shape follows the first number of a depth source, which says so many.
template <void (*Shape)(resource& own, const shape_of& effect)>
constexpr resource of_two_layers(resource described) {
    described.shape = [](resource& own, const shape_of& effect) {
        choice source = effect.own;
        source.numbers[0] = 2;
        Shape(own, {effect.parts, source, effect.views});
    };
    return described;
}

struct static_and_dynamic_layers_part {
    static constexpr number takes[] = {capture_places[0], capture_places[1], capture_places[2]};
    static constexpr resource owns[] = {of_two_layers<shape_fragment_layers>(fragment_layers),
                                        of_two_layers<shape_fragment_surfaces>(fragment_surfaces),
                                        of_two_layers<shape_packed_layers>(packed_layers),
                                        of_two_layers<shape_packed_opacities>(packed_opacities),
                                        of_two_layers<shape_fragment_layers>(layer_surfaces),
                                        compressed_layers,
                                        compressed_normals};
    static constexpr const glsl_file* drawing[] = {&capture_fragment_glsl,
                                                   &static_and_dynamic_layers_draw_glsl, &fragment_key_glsl};
    static constexpr const glsl_file* packing[] = {&pack_fragments_glsl, &static_and_dynamic_layers_sort_glsl,
                                                   &fragments_glsl};
    static constexpr const glsl_file* packing_surfaces[] = {&pack_surfaces_glsl, &order_equal_fragments_glsl,
                                                            &static_and_dynamic_surfaces_sort_glsl,
                                                            &surface_fragments_glsl};
    static constexpr step_constant of_static[] = {{"index", 0}};
    static constexpr step_constant of_dynamic[] = {{"index", 1}};
    static constexpr step passes[] = {
        {.name = "capture_static",
         .files = drawing,
         .widened = {&layers_with_opacity::value, captures_visible_fragments},
         .kind = step_kind::geometry,
         .constants = of_static,
         .writes = fills_fragment_layers,
         .how = access::modify},
        {.name = "capture_dynamic",
         .files = drawing,
         .widened = {&layers_with_opacity::value, captures_visible_fragments},
         .kind = step_kind::geometry,
         .constants = of_dynamic,
         .writes = fills_fragment_layers,
         .how = access::modify},
        capture_surfaces("capture_static_surfaces",
                         captures_surfaces<&static_and_dynamic_layers_kept_key_glsl>, of_static),
        capture_surfaces("capture_dynamic_surfaces",
                         captures_surfaces<&static_and_dynamic_layers_kept_key_glsl>, of_dynamic),
        pack_kept_fragments(packing, packing_surfaces)};
    static constexpr const glsl_file* files[] = {&static_and_dynamic_layers_glsl, &sided_layers_glsl,
                                                 &packed_layers_glsl};
    static constexpr part description{
        .kind = role::depth_source,
        .name = "static_and_dynamic_layers",
        .summary = "the first layer of static and the first of dynamic geometry",
        .source = "HBAO+, NVIDIA; stochastic-depth-ao 2020, 3",
        .files = files,
        .widened = kept_sources_widened,
        .numbers = takes,
        .resources = owns,
        .steps = passes,
        .offers = traits<depth_layers, sorted_layers, layers_behind_front, layers_with_opacity,
                         layers_with_normals, layers_in_strips>::list,
    };
};

/// Depth source: two layers, the nearest fragment of what the host draws in the geometry pass
/// `capture_static` and the nearest of what it draws in `capture_dynamic`, each drawn once. Where their
/// depths are equal there is one. Where layers are needed with their opacity, each is drawn once more, in
/// `capture_static_surfaces` and `capture_dynamic_surfaces`, which keep their colours and normals, and equal
/// depths are two layers. The numbers place its bindings and constants among those of the host's geometry
/// passes.
template <int Set = 0, int FirstBinding = 0, int FirstConstant = 0>
struct static_and_dynamic_layers : static_and_dynamic_layers_part {
    static constexpr int numbers[] = {Set, FirstBinding, FirstConstant};
};

}
