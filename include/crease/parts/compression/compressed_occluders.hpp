// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/compression/nodes.hpp>

namespace crease {

inline constexpr glsl_file compressed_occluders_glsl{
    "compression/compressed_occluders.glsl",
#include <crease/compression/compressed_occluders.glsl>
};

inline constexpr glsl_file pack_compressed_occluders_glsl{
    "compression/pack_compressed_occluders.glsl",
#include <crease/compression/pack_compressed_occluders.glsl>
};

struct compressed_occluders_part {
    using needs = traits<layers_with_opacity, layers_alone>;
    static constexpr const glsl_file* files[] = {&compressed_occluders_glsl, &pack_nodes_glsl, &nodes_glsl};
    static constexpr const glsl_file* with_surfaces[] = {&pack_compressed_occluders_glsl};
    static constexpr files_where widened[] = {{&layers_with_normals::value, with_surfaces}};
    static constexpr part description{
        .kind = role::layer_compression,
        .name = "compressed_occluders",
        .summary = "keeps for taps the few layers of a texel that are the most opaque and near, and all for "
                   "receivers",
        .source = "a-buffer-ssao 2013, III.B and V.A, figure 6 D",
        .files = files,
        .widened = widened,
        .numbers = compression_numbers,
        .needs = needs::list,
        .offers = traits<all_surfaces>::list,
    };
};

/// Layer compression: taps find `Nodes` layers of a texel at the most, as `compressed` keeps them, and
/// receivers all.
template <int Nodes = 4, int Half = 0>
struct compressed_occluders : compressed_occluders_part {
    static constexpr int numbers[] = {Nodes, Half};
};

}
