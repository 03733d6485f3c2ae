// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/depth/surfaces.hpp>

namespace crease {

// Sources that keep the nearest fragments in `fragment_layers`: packing them, and where layers_with_opacity
// is needed a last geometry pass, which keeps the surface of each fragment that has a layer.

inline constexpr glsl_file kept_key_glsl{
    "depth/kept_key.glsl",
#include <crease/depth/kept_key.glsl>
};

inline constexpr glsl_file kept_surface_glsl{
    "depth/kept_surface.glsl",
#include <crease/depth/kept_surface.glsl>
};

inline constexpr glsl_file kept_color_glsl{
    "depth/kept_color.glsl",
#include <crease/depth/kept_color.glsl>
};

inline constexpr glsl_file capture_visible_fragment_glsl{
    "depth/capture_visible_fragment.glsl",
#include <crease/depth/capture_visible_fragment.glsl>
};

inline constexpr glsl_file claim_layer_glsl{
    "depth/claim_layer.glsl",
#include <crease/depth/claim_layer.glsl>
};

inline constexpr glsl_file capture_surfaces_glsl{
    "depth/capture_surfaces.glsl",
#include <crease/depth/capture_surfaces.glsl>
};

inline constexpr glsl_file capture_colors_glsl{
    "depth/capture_colors.glsl",
#include <crease/depth/capture_colors.glsl>
};

inline constexpr glsl_file sorted_surfaces_glsl{
    "depth/sorted_surfaces.glsl",
#include <crease/depth/sorted_surfaces.glsl>
};

/// One for each layer of fragments, and where layers_with_normals is needed another.
constexpr void shape_fragment_surfaces(resource& own, const shape_of& effect) {
    shape_fragment_layers(own, effect);
    if (effect.needs(&layers_with_normals::value))
        own.layers *= 2;
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

/// What a geometry pass that keeps surfaces has and fills.
/// @{
inline constexpr const glsl_file* captures_normals[] = {&capture_surfaces_glsl};
inline constexpr std::string_view fills_fragment_surfaces[] = {"fragment_surfaces"};
/// @}

/// A geometry pass that keeps surfaces.
/// @param name       of the pass
/// @param drawing    with `uint crease_kept_key(ivec2 texel, int layer)`
/// @param constants  that this asks for
constexpr step capture_surfaces(std::string_view name, array_view<const glsl_file* const> drawing,
                                array_view<const step_constant> constants = {}) {
    return {.name = name,
            .files = drawing,
            .widened = {&layers_with_normals::value, captures_normals},
            .kind = step_kind::geometry,
            .constants = constants,
            .writes = fills_fragment_surfaces,
            .how = access::modify,
            .needed = &layers_with_opacity::value};
}

/// The packing pass.
/// @param packing           with `crease_fragments crease_sorted_fragments(ivec2 texel)`
/// @param packing_surfaces  likewise, where layers_with_opacity is needed
constexpr step pack_kept_fragments(array_view<const glsl_file* const> packing,
                                   array_view<const glsl_file* const> packing_surfaces) {
    return {.name = "pack_layers",
            .files = packing,
            .widened = {&layers_with_opacity::value, packing_surfaces},
            .kind = step_kind::texels,
            .writes = fills_surfaces};
}

/// The files of both where the keys stand sorted, but for where `Key` says how.
/// @{
template <const glsl_file* Key>
inline constexpr const glsl_file* captures_surfaces[] = {&capture_colors_glsl, &claim_layer_glsl, Key,
                                                         &fragment_key_glsl, &fragments_glsl};
template <const glsl_file* Key>
inline constexpr const glsl_file* packs_sorted_fragments[] = {&pack_fragments_glsl, &sorted_fragments_glsl,
                                                              Key, &fragments_glsl};
template <const glsl_file* Key>
inline constexpr const glsl_file* packs_sorted_surfaces[] = {
    &pack_surfaces_glsl, &order_equal_fragments_glsl, &sorted_surfaces_glsl, Key, &surface_fragments_glsl};
/// @}

/// What stands before the files of such a source.
/// @{
inline constexpr const glsl_file* keeps_normals[] = {&kept_surface_glsl};
inline constexpr const glsl_file* keeps_colors[] = {&kept_color_glsl};
inline constexpr files_where kept_sources_widened[] = {{&layers_with_normals::value, keeps_normals},
                                                       {&layers_with_opacity::value, keeps_colors},
                                                       packed_sources_widened[0],
                                                       packed_sources_widened[1]};
/// @}

}
