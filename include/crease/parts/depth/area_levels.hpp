// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/depth/areas.hpp>

namespace crease {

inline constexpr glsl_file area_fill_glsl{
    "depth/area_fill.glsl",
#include <crease/depth/area_fill.glsl>
};

/// What pyramids of sums share: the tables are their levels, the first of which holds the texels themselves.
/// As no level sums more than its squares, their sums are more exact than those of a table.
namespace areas {

/// Makes a level of a pyramid of the one before; its GLSL defines how.
template <int Level>
inline constexpr step_constant level_constants[] = {{"level", Level, "areas"}};
template <int Level>
constexpr step level(std::string_view name, array_view<const glsl_file* const> own) {
    return {.name = name,
            .files = own,
            .kind = step_kind::texels,
            .constants = level_constants<Level>,
            .writes = tables_name,
            .how = access::modify,
            .group_width = wide,
            .group_height = flat,
            .from = Level + 1};
}

inline constexpr const glsl_file* area_fill_files[] = {&area_fill_glsl};
template <const glsl_file* Level>
inline constexpr const glsl_file* level_files[] = {Level};

/// All that makes a pyramid.
template <const glsl_file* Level>
inline constexpr step levels[] = {
    range_of_columns,
    range_of_picture,
    fill("level_0", area_fill_files),
    level<1>("level_1", level_files<Level>),
    level<2>("level_2", level_files<Level>),
    level<3>("level_3", level_files<Level>),
    level<4>("level_4", level_files<Level>),
    level<5>("level_5", level_files<Level>),
    level<6>("level_6", level_files<Level>),
    level<7>("level_7", level_files<Level>),
    level<8>("level_8", level_files<Level>),
    level<9>("level_9", level_files<Level>),
};
inline constexpr number levels_take[] = {
    {"levels", 1, 10, 9, "levels, the last of squares of 2^(levels - 1) texels to a side"},
    {"divisor", 1, 4, 1, "how much smaller the sides of the first level are"}};

}

}
