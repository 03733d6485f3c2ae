// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/compression/nodes.hpp>

namespace crease {

inline constexpr glsl_file compressed_glsl{
    "compression/compressed.glsl",
#include <crease/compression/compressed.glsl>
};

inline constexpr glsl_file pack_compressed_glsl{
    "compression/pack_compressed.glsl",
#include <crease/compression/pack_compressed.glsl>
};

struct compressed_part {
    using needs = traits<layers_with_opacity, layers_alone>;
    static constexpr const glsl_file* files[] = {&compressed_glsl, &pack_nodes_glsl, &nodes_glsl};
    static constexpr const glsl_file* with_normals[] = {&pack_compressed_glsl};
    static constexpr files_where widened[] = {{&layers_with_normals::value, with_normals}};
    static constexpr part description{
        .kind = role::layer_compression,
        .name = "compressed",
        .summary = "keeps the few layers of a texel that are the most opaque and near",
        .source = "a-buffer-ssao 2013, III.B, (5)",
        .files = files,
        .widened = widened,
        .numbers = compression_numbers,
        .needs = needs::list,
    };
};

/// Layer compression: taps and receivers find `Nodes` layers of a texel at the most, those with the greatest
/// opacity times nearness, in 24 bytes for each four, or 16 where no receiver reads their normals; where
/// `Half` is 1, the nearer half of them are the nearest layers.
template <int Nodes = 4, int Half = 0>
struct compressed : compressed_part {
    static constexpr int numbers[] = {Nodes, Half};
};

}
