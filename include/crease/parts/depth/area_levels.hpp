// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/depth/areas.hpp>

namespace crease {

inline constexpr glsl_file area_fill_glsl{
    "depth/area_fill.glsl",
#include <crease/depth/area_fill.glsl>
};

inline constexpr glsl_file area_levels_glsl{
    "depth/area_levels.glsl",
#include <crease/depth/area_levels.glsl>
};

inline constexpr glsl_file area_levels_even_glsl{
    "depth/area_levels_even.glsl",
#include <crease/depth/area_levels_even.glsl>
};

inline constexpr glsl_file area_levels_odd_glsl{
    "depth/area_levels_odd.glsl",
#include <crease/depth/area_levels_odd.glsl>
};

/// What pyramids of sums share: levels, the first of which holds the texels themselves. As no level sums more
/// than its squares, their sums are more exact than those of a table.
namespace areas {

/// The levels of odd number; where there are none, one that nothing reads.
constexpr void shape_odd(resource& own, const shape_of& effect) {
    shape_tables(own, effect);
    own.cleared = own.layers == 1;
    own.layers = own.cleared ? 1 : own.layers / 2;
}
inline constexpr resource images_of_levels[] = {
    image("even_levels", shape_half), image("odd_levels", shape_odd), range, range_of_columns_image};
inline constexpr std::string_view even_name[] = {"even_levels"}, odd_name[] = {"odd_levels"};

/// Makes a level of a pyramid of the one before, which is in the other image; the GLSL in `Own` defines how.
template <int Level>
inline constexpr step_constant level_constants[] = {{"level", Level, "areas"}};
template <const glsl_file* Own, int Level>
inline constexpr const glsl_file* level_files[] = {Own, Level % 2 == 0 ? &area_levels_even_glsl
                                                                       : &area_levels_odd_glsl};
template <const glsl_file* Own, int Level>
constexpr step level(std::string_view name) {
    step own = fill(name, level_files<Own, Level>, even_name);
    if (Level % 2 == 1)
        own.writes = odd_name;
    own.constants = level_constants<Level>;
    own.from = Level + 1;
    return own;
}

inline constexpr const glsl_file* area_fill_files[] = {&area_fill_glsl};

/// All that makes a pyramid.
template <const glsl_file* Own>
inline constexpr step levels[] = {
    range_of_columns,         range_of_picture,         fill("level_0", area_fill_files, even_name),
    level<Own, 1>("level_1"), level<Own, 2>("level_2"), level<Own, 3>("level_3"),
    level<Own, 4>("level_4"), level<Own, 5>("level_5"), level<Own, 6>("level_6"),
    level<Own, 7>("level_7"), level<Own, 8>("level_8"), level<Own, 9>("level_9"),
};
inline constexpr number levels_take[] = {
    {"levels", 1, 10, 9, "levels, the last of squares of 2^(levels - 1) texels to a side"},
    {"divisor", 1, 4, 1, "how much smaller the sides of the first level are"}};

/// What the passes and the main pass of a pyramid share, after its own GLSL.
template <const glsl_file* Own>
inline constexpr const glsl_file* files_of_levels[] = {
    Own, &range_glsl, &area_texel_glsl, &area_mean_glsl, &area_levels_glsl, &area_box_glsl};

}

}
