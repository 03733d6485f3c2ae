// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/depth/fragments.hpp>
#include <crease/parts/storage/captures.hpp>

namespace crease {

inline constexpr glsl_file peeled_layers_glsl{
    "depth/peeled_layers.glsl",
#include <crease/depth/peeled_layers.glsl>
};

inline constexpr glsl_file peeled_layers_draw_glsl{
    "depth/peeled_layers_draw.glsl",
#include <crease/depth/peeled_layers_draw.glsl>
};

namespace peeling {

inline constexpr const glsl_file* drawing[] = {&peeled_layers_draw_glsl, &fragment_key_glsl};
inline constexpr std::string_view drawn[] = {"fragment_layers"};
inline constexpr step_constant indices[][1] = {{{"index", 0}}, {{"index", 1}}, {{"index", 2}},
                                               {{"index", 3}}, {{"index", 4}}, {{"index", 5}},
                                               {{"index", 6}}, {{"index", 7}}};

/// The pass that keeps the layer of an index, where there are so many.
constexpr step peel(std::string_view name, int index) {
    return {.name = name,
            .files = drawing,
            .kind = step_kind::geometry,
            .constants = indices[index],
            .writes = drawn,
            .how = access::modify,
            .from = index + 1};
}

}

struct peeled_layers_part {
    static constexpr number takes[] = {
        {"layers", 1, 8, 4, "layers of a texel that are kept, the nearest; the geometry is drawn as often"},
        capture_places[0],
        capture_places[1],
        capture_places[2]};
    static constexpr resource owns[] = {fragment_layers, packed_layers};
    static constexpr const glsl_file* packing[] = {&pack_fragments_glsl, &sorted_fragments_glsl,
                                                   &fragments_glsl};
    static constexpr step passes[] = {
        peeling::peel("peel_layer_0", 0),
        peeling::peel("peel_layer_1", 1),
        peeling::peel("peel_layer_2", 2),
        peeling::peel("peel_layer_3", 3),
        peeling::peel("peel_layer_4", 4),
        peeling::peel("peel_layer_5", 5),
        peeling::peel("peel_layer_6", 6),
        peeling::peel("peel_layer_7", 7),
        {.name = "pack_layers", .files = packing, .kind = step_kind::texels, .writes = fills_packed_layers}};
    static constexpr const glsl_file* files[] = {&peeled_layers_glsl, &sided_layers_glsl,
                                                 &packed_layers_glsl};
    static constexpr files_where more[] = {{&layers_in_strips::value, packed_layers_strips}};
    static constexpr part description{
        .kind = role::depth_source,
        .name = "peeled_layers",
        .summary = "the nearest layers of each texel, exactly, in a geometry pass each",
        .source = "depth peeling, Everitt 2001; the baseline of a-buffer-ssao 2013, V",
        .files = files,
        .widened = more,
        .numbers = takes,
        .resources = owns,
        .steps = passes,
        .offers = traits<depth_layers, layers_behind_front, layers_in_strips>::list,
    };
};

/// Depth source: the `Layers` nearest fragments of each texel, front and back faces told apart, each in a
/// geometry pass of its own. Of fragments of one depth and side one counts; what is farther is not seen, and
/// so not counted. The other numbers place its bindings and constants among those of the host's geometry
/// pass.
template <int Layers = 4, int Set = 0, int FirstBinding = 0, int FirstConstant = 0>
struct peeled_layers : peeled_layers_part {
    static constexpr int numbers[] = {Layers, Set, FirstBinding, FirstConstant};
};

}
