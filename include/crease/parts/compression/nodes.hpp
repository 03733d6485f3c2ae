// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/depth/layers.hpp>
#include <crease/parts/traversal/all_layers.hpp>

namespace crease {

inline constexpr glsl_file nodes_glsl{
    "compression/nodes.glsl",
#include <crease/compression/nodes.glsl>
};

inline constexpr glsl_file pack_nodes_glsl{
    "compression/pack_nodes.glsl",
#include <crease/compression/pack_nodes.glsl>
};

/// Keeps all surfaces for receivers, with their colours.
CREASE_TRAIT(all_surfaces, layer_compression,
             "the output blends the colours of all layers, and the compression keeps them of none");

/// The numbers of a compression.
inline constexpr number compression_numbers[] = {
    {"nodes", 1, 8, 4, "layers of a texel that are kept, those that are opaque and near"},
    {"half", 0, 1, 0, "1: the nearer half of them are the nearest, whatever their opacity; 0: none are"}};

}
