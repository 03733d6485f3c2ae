// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/depth/areas.hpp>

namespace crease {

inline constexpr glsl_file summed_area_glsl{
    "depth/summed_area.glsl",
#include <crease/depth/summed_area.glsl>
};

struct summed_area_part {
    using needs = areas::needs;
    static constexpr number takes[] = {{"divisor", 1, 4, 1, "how much smaller the sides of the table are"}};
    static constexpr step passes[] = {
        areas::range_of_columns,
        areas::range_of_picture,
        areas::make_rows,
        areas::sum_columns<0, 1>("sum_columns"),
    };
    static constexpr part description = areas::source_of_tables({
        .kind = role::depth_source,
        .name = "summed_area",
        .summary = "a summed-area table of the depth buffer: the mean of any area from four places",
        .source = "statistical-volumetric-obscurance 2015, 3.4, 4.2 and 4.6.1",
        .files = areas::files<&summed_area_glsl>,
        .numbers = takes,
        .steps = passes,
    });
};

/// Depth source: one summed-area table, of 1 / `Divisor` of the picture's size each way.
template <int Divisor = 1>
struct summed_area : summed_area_part {
    static constexpr int numbers[] = {Divisor};
};

}
