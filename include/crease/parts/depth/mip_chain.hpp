// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/depth/area_levels.hpp>

namespace crease {

inline constexpr glsl_file mip_chain_glsl{
    "depth/mip_chain.glsl",
#include <crease/depth/mip_chain.glsl>
};

inline constexpr glsl_file mip_chain_level_glsl{
    "depth/mip_chain_level.glsl",
#include <crease/depth/mip_chain_level.glsl>
};

struct mip_chain_part {
    using needs = areas::needs;
    static constexpr part description = areas::source(
        {
            .kind = role::depth_source,
            .name = "mip_chain",
            .summary = "a mip chain of sums: an area is what a trilinear filter takes for it",
            .source = "statistical-volumetric-obscurance 2015, 3.3",
            .files = areas::files_of_levels<&mip_chain_glsl>,
            .numbers = areas::levels_take,
            .steps = areas::levels<&mip_chain_level_glsl>,
        },
        areas::images_of_levels);
};

/// Depth source: a mip chain of `Levels` levels, the first of 1 / `Divisor` of the picture's size each way.
template <int Levels = 9, int Divisor = 1>
struct mip_chain : mip_chain_part {
    static constexpr int numbers[] = {Levels, Divisor};
};

}
