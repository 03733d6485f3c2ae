// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/depth/surfaces.hpp>

namespace crease {

// Sources that keep the nearest fragments sorted in `fragment_layers`: packing them, and where
// layers_with_opacity is needed a last geometry pass, which keeps the surface of each fragment that has a
// layer.

inline constexpr glsl_file capture_visible_fragment_glsl{
    "depth/capture_visible_fragment.glsl",
#include <crease/depth/capture_visible_fragment.glsl>
};

inline constexpr glsl_file capture_surfaces_glsl{
    "depth/capture_surfaces.glsl",
#include <crease/depth/capture_surfaces.glsl>
};

inline constexpr glsl_file sorted_surfaces_glsl{
    "depth/sorted_surfaces.glsl",
#include <crease/depth/sorted_surfaces.glsl>
};

/// Two for each layer of fragments.
constexpr void shape_fragment_surfaces(resource& own, const shape_of& effect) {
    own.layers = 2 * static_cast<unsigned>(effect.own.numbers[0]);
}

/// The colours of the fragments, 0 where there is none, and then their normals.
inline constexpr resource fragment_surfaces{.name = "fragment_surfaces",
                                            .texels = format::r32_uint,
                                            .life = lifetime::transient,
                                            .size = {.guarded = true},
                                            .arrayed = true,
                                            .read = access::load,
                                            .cleared = true,
                                            .shape = shape_fragment_surfaces};

/// What is captured where opacity counts, before other files.
inline constexpr const glsl_file* captures_visible_fragments[] = {&capture_visible_fragment_glsl};

/// The geometry pass that keeps the surfaces.
/// @{
inline constexpr const glsl_file* captures_surfaces[] = {&capture_surfaces_glsl, &fragment_key_glsl};
inline constexpr std::string_view fills_fragment_surfaces[] = {"fragment_surfaces"};
inline constexpr step capture_surfaces{.name = "capture_surfaces",
                                       .files = captures_surfaces,
                                       .kind = step_kind::geometry,
                                       .writes = fills_fragment_surfaces,
                                       .how = access::modify,
                                       .needed = &layers_with_opacity::value};
/// @}

/// The packing pass.
/// @{
inline constexpr const glsl_file* packs_sorted_fragments[] = {&pack_fragments_glsl, &sorted_fragments_glsl,
                                                              &fragments_glsl};
inline constexpr const glsl_file* packs_sorted_surfaces[] = {&pack_surfaces_glsl, &sorted_surfaces_glsl,
                                                             &surface_fragments_glsl};
inline constexpr step pack_sorted_fragments{.name = "pack_layers",
                                            .files = packs_sorted_fragments,
                                            .widened = {&layers_with_opacity::value, packs_sorted_surfaces},
                                            .kind = step_kind::texels,
                                            .writes = fills_surfaces};
/// @}

}
