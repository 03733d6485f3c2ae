// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/depth/peeling.hpp>

namespace crease {

inline constexpr glsl_file peeled_layers_glsl{
    "depth/peeled_layers.glsl",
#include <crease/depth/peeled_layers.glsl>
};

inline constexpr glsl_file peeled_layers_behind_glsl{
    "depth/peeled_layers_behind.glsl",
#include <crease/depth/peeled_layers_behind.glsl>
};

struct peeled_layers_part {
    static constexpr number takes[] = {
        {"layers", 1, 8, 4, "layers of a texel that are kept, the nearest; the geometry is drawn as often"},
        capture_places[0],
        capture_places[1],
        capture_places[2]};
    static constexpr const glsl_file* files[] = {&peeled_layers_glsl, &sided_layers_glsl,
                                                 &packed_layers_glsl};
    static constexpr part description{
        .kind = role::depth_source,
        .name = "peeled_layers",
        .summary = "the nearest layers of each texel, exactly, in a geometry pass each",
        .source = "depth peeling, Everitt 2001; the baseline of a-buffer-ssao 2013, V",
        .files = files,
        .widened = kept_sources_widened,
        .numbers = takes,
        .resources = peeling::resources,
        .steps = peeling::nearest_first<&peeled_layers_behind_glsl>,
        .offers = peeling::offered::list,
    };
};

/// Depth source: the `Layers` nearest fragments of each texel, front and back faces told apart, each in a
/// geometry pass of its own. Of fragments of one depth and side one counts; what is farther is not seen, and
/// so not counted. Where layers are needed with their opacity, a last geometry pass, `capture_surfaces`,
/// keeps their colours and normals. All passes must meet the same fragments. The other numbers place its
/// bindings and constants among those of the host's geometry pass.
template <int Layers = 4, int Set = 0, int FirstBinding = 0, int FirstConstant = 0>
struct peeled_layers : peeled_layers_part {
    static constexpr int numbers[] = {Layers, Set, FirstBinding, FirstConstant};
};

}
