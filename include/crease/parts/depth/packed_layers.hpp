// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/depth/layers.hpp>

namespace crease {

inline constexpr glsl_file packed_layers_glsl{
    "depth/packed_layers.glsl",
#include <crease/depth/packed_layers.glsl>
};

inline constexpr glsl_file packed_layers_strips_glsl{
    "depth/packed_layers_strips.glsl",
#include <crease/depth/packed_layers_strips.glsl>
};

/// What stands before the files of such a source where the stage keeps layers in shared memory.
/// @{
inline constexpr const glsl_file* packed_layers_strips[] = {&packed_layers_strips_glsl};
inline constexpr files_where packed_layers_widened[] = {{&layers_in_strips::value, packed_layers_strips}};
/// @}

/// As many layers as the first number of the depth source says, in groups of four in a texel each, those of
/// each camera in a row.
constexpr void shape_packed_layers(resource& own, const shape_of& effect) {
    const int count = effect.own.numbers[0];
    own.layers = static_cast<unsigned>((count + 3) / 4) * effect.views;
    if (effect.needs(&layers_with_opacity::value))
        own.texels = format::rgba32_float;
    else
        own.texels = count == 1 ? format::r32_float : count == 2 ? format::rg32_float : format::rgba32_float;
}

/// What taps read of a depth source that packs its layers.
inline constexpr resource packed_layers{.name = "packed_layers",
                                        .life = lifetime::transient,
                                        .size = {.guarded = true},
                                        .arrayed = true,
                                        .read = access::load,
                                        .shape = shape_packed_layers};

}
