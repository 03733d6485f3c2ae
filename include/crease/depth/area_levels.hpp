// SPDX-License-Identifier: MIT
#pragma once

#include <crease/depth/areas.hpp>

namespace crease {

inline constexpr glsl_file area_fill_glsl{
    "depth/area_fill.glsl",
#include <crease/depth/area_fill.glsl>
};

/// What pyramids of sums share: the tables are their levels, the first of which holds the texels themselves.
/// As no level sums more than its squares, their sums are more exact than those of a table.
namespace areas {

inline constexpr const glsl_file* level_helpers[] = {&area_layers_glsl, &range_glsl, &area_mean_glsl,
                                                     &areas_stored_glsl, &area_box_glsl};
inline constexpr const glsl_file* stored_level_helpers[] = {&areas_stored_glsl};

/// Makes a level of a pyramid of the one before; its body defines how.
template <int Level>
inline constexpr step_constant level_constants[] = {{"level", Level, "areas"}};
template <int Level>
constexpr step level(std::string_view name, const glsl_file* body) {
    return {.name = name,
            .body = body,
            .kind = step_kind::build,
            .helpers = stored_level_helpers,
            .constants = level_constants<Level>,
            .writes = tables_name,
            .how = access::modify,
            .group_width = wide,
            .group_height = flat,
            .from = Level + 1};
}

/// All that makes a pyramid.
template <const glsl_file* Level>
inline constexpr step levels[] = {
    range_of_columns,           range_of_picture,           fill("level_0", &area_fill_glsl),
    level<1>("level_1", Level), level<2>("level_2", Level), level<3>("level_3", Level),
    level<4>("level_4", Level), level<5>("level_5", Level), level<6>("level_6", Level),
    level<7>("level_7", Level), level<8>("level_8", Level), level<9>("level_9", Level),
};
inline constexpr number levels_take[] = {
    {"levels", 1, 10, 9, "of which the last takes in squares of 2^(levels - 1) texels to a side"},
    {"divisor", 1, 4, 1, "how much smaller the sides of the first are"}};
inline constexpr resource levels_read[] = {tables({.number = 0}, 1), range};

/// A depth source that is a pyramid; what its description leaves open is the same for all.
constexpr part source_of_levels(part own) {
    own.helpers = level_helpers;
    return source(own);
}

}

}
