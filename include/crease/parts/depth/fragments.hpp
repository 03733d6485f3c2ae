// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/depth/packed_layers.hpp>

namespace crease {

inline constexpr glsl_file fragments_glsl{
    "depth/fragments.glsl",
#include <crease/depth/fragments.glsl>
};

inline constexpr glsl_file fragment_key_glsl{
    "depth/fragment_key.glsl",
#include <crease/depth/fragment_key.glsl>
};

inline constexpr glsl_file capture_fragment_glsl{
    "depth/capture_fragment.glsl",
#include <crease/depth/capture_fragment.glsl>
};

inline constexpr glsl_file insert_fragment_glsl{
    "depth/insert_fragment.glsl",
#include <crease/depth/insert_fragment.glsl>
};

inline constexpr glsl_file pack_fragments_glsl{
    "depth/pack_fragments.glsl",
#include <crease/depth/pack_fragments.glsl>
};

inline constexpr glsl_file sorted_fragments_glsl{
    "depth/sorted_fragments.glsl",
#include <crease/depth/sorted_fragments.glsl>
};

inline constexpr glsl_file sided_layers_glsl{
    "depth/sided_layers.glsl",
#include <crease/depth/sided_layers.glsl>
};

/// How many of the nearest fragments of a texel a depth source packs.
inline constexpr number fragment_layers_number{"layers", 1, 32, 8,
                                               "layers of a texel that are kept, the nearest"};

/// As many layers as the first number of the depth source says.
constexpr void shape_fragment_layers(resource& own, const shape_of& effect) {
    own.layers = static_cast<unsigned>(effect.own.numbers[0]);
}

/// An array image of the nearest fragments of each texel, sorted.
inline constexpr resource fragment_layers{.name = "fragment_layers",
                                          .texels = format::r32_uint,
                                          .life = lifetime::transient,
                                          .size = {.guarded = true},
                                          .arrayed = true,
                                          .read = access::load,
                                          .cleared = true,
                                          .clear = ~0u,
                                          .shape = shape_fragment_layers};

/// A counter that is read back after each frame; where it is not 0 the host has something to do.
constexpr resource fragments_lost(std::string_view name, std::string_view meaning) {
    return {.name = name,
            .kind = resource_kind::buffer,
            .element = "uint",
            .life = lifetime::report,
            .size = {.fixed_width = 1, .fixed_height = 1},
            .meaning = meaning,
            .cleared = true};
}

/// Fragments behind the layers of their texels.
inline constexpr resource fragments_beyond_layers =
    fragments_lost("fragments_beyond_layers",
                   "fragments that lie behind the layers kept of their texel: more layers keep them");

/// The size of the pool of a depth source of lists.
inline constexpr number pool_nodes_number{
    "nodes", 1, 64, 8, "size of the pool: nodes for each texel, on average; each texel has one more"};

/// As many nodes for each texel as the second number of the depth source says.
constexpr void shape_pool(resource& own, const shape_of& effect) {
    own.layers = static_cast<unsigned>(effect.own.numbers[1]);
}

/// Fragments that found no node.
inline constexpr resource fragments_beyond_pool =
    fragments_lost("fragments_beyond_pool",
                   "fragments that found the pool of nodes full: more nodes for each texel keep them");

/// What a geometry pass fills.
inline constexpr std::string_view fills_fragment_layers[] = {"fragment_layers"};

}
