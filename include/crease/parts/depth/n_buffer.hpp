// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/depth/area_levels.hpp>

namespace crease {

inline constexpr glsl_file n_buffer_glsl{
    "depth/n_buffer.glsl",
#include <crease/depth/n_buffer.glsl>
};

inline constexpr glsl_file n_buffer_level_glsl{
    "depth/n_buffer_level.glsl",
#include <crease/depth/n_buffer_level.glsl>
};

struct n_buffer_part {
    using needs = areas::needs;
    static constexpr part description = areas::source(
        {
            .kind = role::depth_source,
            .name = "n_buffer",
            .summary = "sums over squares of each power of two at each texel: an area is four of them",
            .source = "statistical-volumetric-obscurance 2015, 3.3",
            .files = areas::files_of_levels<&n_buffer_glsl>,
            .numbers = areas::levels_take,
            .steps = areas::levels<&n_buffer_level_glsl>,
        },
        areas::images_of_levels);
};

/// Depth source: an N-buffer, squares of up to 2^(`Levels` - 1) texels to a side, wider areas by their
/// corners. Where `Divisor` is 2 or 4 it is the paper's Y-map, of one or two mip steps.
template <int Levels = 9, int Divisor = 1>
struct n_buffer : n_buffer_part {
    static constexpr int numbers[] = {Levels, Divisor};
};

}
