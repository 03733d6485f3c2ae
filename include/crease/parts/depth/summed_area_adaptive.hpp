// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/depth/areas.hpp>
#include <crease/parts/sampler/taps.hpp>

namespace crease {

inline constexpr glsl_file summed_area_adaptive_glsl{
    "depth/summed_area_adaptive.glsl",
#include <crease/depth/summed_area_adaptive.glsl>
};

inline constexpr glsl_file summed_area_adaptive_split_glsl{
    "depth/summed_area_adaptive_split.glsl",
#include <crease/depth/summed_area_adaptive_split.glsl>
};

inline constexpr glsl_file scan_split_glsl{
    "depth/scan_split.glsl",
#include <crease/depth/scan_split.glsl>
};

namespace areas {

/// A level makes no more than half of all tables.
inline constexpr resource images_of_splits[] = {
    tables, image("area_splits", shape_half), image("area_rows", shape_half), range, range_of_columns_image};
inline constexpr std::string_view splits_name[] = {"area_splits"};
inline constexpr const glsl_file* split_files[] = {&summed_area_adaptive_split_glsl, &sample_area_glsl};

/// The tables from `First` on split the layers of one level.
template <int First>
inline constexpr step_constant splits[] = {{"split", First}};
template <int First>
constexpr step split(std::string_view name) {
    return {.name = name,
            .files = split_files,
            .kind = step_kind::texels,
            .constants = splits<First>,
            .writes = splits_name,
            .group_width = wide,
            .group_height = flat,
            .from = First + 1};
}

}

struct summed_area_adaptive_part {
    using needs = areas::needs;
    static constexpr number takes[] = {
        {"layers", 2, 8, 4, "layers that the recursive splits leave, and as many tables"},
        {"divisor", 1, 4, 1, "how much smaller the sides of the tables are"},
    };

    static constexpr step passes[] = {
        areas::range_of_columns,
        areas::range_of_picture,
        areas::make_rows,
        areas::sum_columns<0, 1>("sum_columns_0"),
        areas::split<1>("split_1"),
        areas::sum_rows<&scan_split_glsl, 1, 2>("sum_rows_1", 2),
        areas::sum_columns<1, 2>("sum_columns_1", 2),
        areas::split<2>("split_2"),
        areas::sum_rows<&scan_split_glsl, 2, 4>("sum_rows_2", 3),
        areas::sum_columns<2, 4>("sum_columns_2", 3),
        areas::split<4>("split_3"),
        areas::sum_rows<&scan_split_glsl, 4, 8>("sum_rows_3", 5),
        areas::sum_columns<4, 8>("sum_columns_3", 5),
    };
    static constexpr part description = areas::source_of_tables(
        {
            .kind = role::depth_source,
            .name = "summed_area_adaptive",
            .summary = "summed-area tables of layers that are split by the mean around each texel",
            .source = "statistical-volumetric-obscurance 2015, 4.4 and 4.6, Algorithm 2",
            .files = areas::files<&summed_area_adaptive_glsl>,
            .numbers = takes,
            .steps = passes,
        },
        areas::images_of_splits);
};

/// Depth source: `Layers` layers out of as many summed-area tables, of 1 / `Divisor` of the picture's size
/// each way. The layers are split by the mean over the box of the AO radius.
template <int Layers = 4, int Divisor = 1>
struct summed_area_adaptive : summed_area_adaptive_part {
    static constexpr int numbers[] = {Layers, Divisor};
};

}
