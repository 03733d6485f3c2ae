// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/depth/peeling.hpp>

namespace crease {

inline constexpr glsl_file separated_layers_glsl{
    "depth/separated_layers.glsl",
#include <crease/depth/separated_layers.glsl>
};

inline constexpr glsl_file separated_layers_behind_glsl{
    "depth/separated_layers_behind.glsl",
#include <crease/depth/separated_layers_behind.glsl>
};

struct separated_layers_part {
    static constexpr number takes[] = {
        {"layers", 1, 8, 2, "layers of a texel that are kept; the geometry is drawn as often"},
        capture_places[0],
        capture_places[1],
        capture_places[2]};
    static constexpr setting reads[] = {
        {"separation", 0.2f, 0, 1000, "least depth from one layer to the next, in radii"}};
    static constexpr const glsl_file* files[] = {&separated_layers_glsl, &sided_layers_glsl,
                                                 &packed_layers_glsl};
    static constexpr part description{
        .kind = role::depth_source,
        .name = "separated_layers",
        .summary = "the first layer, and the nearest that lies a least separation behind it",
        .source = "deep G-buffers, Mara et al. 2016",
        .files = files,
        .widened = kept_sources_widened,
        .numbers = takes,
        .settings = reads,
        .resources = peeling::resources,
        .steps = peeling::nearest_first<&separated_layers_behind_glsl>,
        .offers = peeling::offered::list,
    };
};

/// Depth source: the nearest fragment of each texel, and the nearest that lies at least the setting
/// `separation` behind it, in radii of linear depth; of more `Layers` each as far behind the one before. Each
/// is kept in a geometry pass of its own. With a separation of 0 it is `peeled_layers`. What is skipped
/// between two layers counts for nothing, so that a front face before a back face is solid all the way. The
/// other numbers place its bindings and constants among those of the host's geometry pass.
template <int Layers = 2, int Set = 0, int FirstBinding = 0, int FirstConstant = 0>
struct separated_layers : separated_layers_part {
    static constexpr int numbers[] = {Layers, Set, FirstBinding, FirstConstant};
};

}
