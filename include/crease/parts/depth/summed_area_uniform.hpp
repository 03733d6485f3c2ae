// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/depth/areas.hpp>

namespace crease {

inline constexpr glsl_file summed_area_uniform_glsl{
    "depth/summed_area_uniform.glsl",
#include <crease/depth/summed_area_uniform.glsl>
};

inline constexpr glsl_file summed_area_uniform_fill_glsl{
    "depth/summed_area_uniform_fill.glsl",
#include <crease/depth/summed_area_uniform_fill.glsl>
};

inline constexpr glsl_file scan_filled_glsl{
    "depth/scan_filled.glsl",
#include <crease/depth/scan_filled.glsl>
};

struct summed_area_uniform_part {
    using needs = areas::needs;
    static constexpr number takes[] = {
        {"layers", 1, 64, 16, "layers of equal depth, from the nearest to the farthest of the picture"},
        {"divisor", 1, 4, 1, "how much smaller the sides of the tables are"},
    };
    static constexpr const glsl_file* splitting[] = {&summed_area_uniform_fill_glsl};
    static constexpr step passes[] = {
        areas::range_of_columns,
        areas::range_of_picture,
        areas::fill("split", splitting, areas::tables_name),
        areas::sum_rows<&scan_filled_glsl, 0, takes[0].most>("sum_rows"),
        areas::sum_columns<0, takes[0].most>("sum_columns"),
    };
    static constexpr part description = areas::source_of_tables({
        .kind = role::depth_source,
        .name = "summed_area_uniform",
        .summary = "summed-area tables of layers of equal depth",
        .source = "statistical-volumetric-obscurance 2015, 4.3 and 4.6.1",
        .files = areas::files<&summed_area_uniform_glsl>,
        .numbers = takes,
        .steps = passes,
    });
};

/// Depth source: `Layers` summed-area tables, of 1 / `Divisor` of the picture's size each way. They and the
/// sums of rows that they are made of take 16 bytes a texel each, and time in proportion.
template <int Layers = 16, int Divisor = 1>
struct summed_area_uniform : summed_area_uniform_part {
    static constexpr int numbers[] = {Layers, Divisor};
};

}
