// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/depth/peeling.hpp>

namespace crease {

inline constexpr glsl_file dual_peeled_layers_glsl{
    "depth/dual_peeled_layers.glsl",
#include <crease/depth/dual_peeled_layers.glsl>
};

inline constexpr glsl_file dual_peel_layers_glsl{
    "depth/dual_peel_layers.glsl",
#include <crease/depth/dual_peel_layers.glsl>
};

inline constexpr glsl_file dual_kept_key_glsl{
    "depth/dual_kept_key.glsl",
#include <crease/depth/dual_kept_key.glsl>
};

inline constexpr glsl_file dual_sorted_surfaces_glsl{
    "depth/dual_sorted_surfaces.glsl",
#include <crease/depth/dual_sorted_surfaces.glsl>
};

struct dual_peeled_layers_part {
    static constexpr number takes[] = {
        {"layers", 1, 16, 8,
         "layers of a texel that are kept, half of them the nearest and half the farthest; the geometry is "
         "drawn half as often"},
        capture_places[0],
        capture_places[1],
        capture_places[2]};
    static constexpr const glsl_file* drawing[] = {&capture_fragment_glsl, &dual_peel_layers_glsl,
                                                   &fragment_key_glsl};
    static constexpr const glsl_file* packing_surfaces[] = {&pack_surfaces_glsl, &order_equal_fragments_glsl,
                                                            &dual_sorted_surfaces_glsl, &dual_kept_key_glsl,
                                                            &surface_fragments_glsl};
    static constexpr step passes[] = {
        peeling::peel<0>("peel_layers_0", drawing, 1),
        peeling::peel<1>("peel_layers_1", drawing, 3),
        peeling::peel<2>("peel_layers_2", drawing, 5),
        peeling::peel<3>("peel_layers_3", drawing, 7),
        peeling::peel<4>("peel_layers_4", drawing, 9),
        peeling::peel<5>("peel_layers_5", drawing, 11),
        peeling::peel<6>("peel_layers_6", drawing, 13),
        peeling::peel<7>("peel_layers_7", drawing, 15),
        capture_surfaces("capture_surfaces", captures_surfaces<&dual_kept_key_glsl>),
        pack_kept_fragments(packs_sorted_fragments<&dual_kept_key_glsl>, packing_surfaces)};
    static constexpr const glsl_file* files[] = {&dual_peeled_layers_glsl, &sided_layers_glsl,
                                                 &packed_layers_glsl};
    static constexpr part description{
        .kind = role::depth_source,
        .name = "dual_peeled_layers",
        .summary =
            "the nearest and the farthest layers of each texel, exactly, in a geometry pass for each two",
        .source = "dual depth peeling, Bavoil and Myers 2008; a-buffer-ssao 2013, V",
        .files = files,
        .widened = kept_sources_widened,
        .numbers = takes,
        .resources = peeling::resources,
        .steps = passes,
        .offers = peeling::offered::list,
    };
};

/// Depth source: as `peeled_layers`, but each geometry pass keeps the nearest and the farthest of what is
/// left of a texel. Of more fragments than `Layers`, half are the nearest, one more where the number is odd,
/// and the others the farthest; what lies between them is lost, and not counted. Where layers are needed with
/// their opacity, a last geometry pass, `capture_surfaces`, keeps their colours and normals. The other
/// numbers place its bindings and constants among those of the host's geometry pass.
template <int Layers = 8, int Set = 0, int FirstBinding = 0, int FirstConstant = 0>
struct dual_peeled_layers : dual_peeled_layers_part {
    static constexpr int numbers[] = {Layers, Set, FirstBinding, FirstConstant};
};

}
