// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/depth/layers.hpp>
#include <crease/parts/sampler/taps.hpp>

namespace crease {

/// Sums a single value over areas, so that two channels of a table hold it and the count.
CREASE_TRAIT(single_area_value, estimator, "one value must be all that is summed over areas, and it is not");

/// What the means over areas are of, by three functions that the passes of the tables and the main pass call:
/// `float crease_area_depth(float depth)`, the depth with which a texel counts, 0 where it does not;
/// `vec3 crease_area_value(vec3 position, float centre)`, what is summed, its x the less the farther and next
/// to 0 about the depth `centre`; and back, `vec3 crease_area_position(vec3 value, float centre)`. The
/// contribution of a layer counts by `crease_layer::texels`.
CREASE_TRAIT(area_means, estimator,
             "the depth source holds means over areas, of which the estimator makes nothing");

inline constexpr glsl_file area_box_glsl{
    "depth/area_box.glsl",
#include <crease/depth/area_box.glsl>
};

inline constexpr glsl_file area_mean_glsl{
    "depth/area_mean.glsl",
#include <crease/depth/area_mean.glsl>
};

inline constexpr glsl_file area_query_glsl{
    "depth/area_query.glsl",
#include <crease/depth/area_query.glsl>
};

inline constexpr glsl_file area_texel_glsl{
    "depth/area_texel.glsl",
#include <crease/depth/area_texel.glsl>
};

inline constexpr glsl_file areas_stored_glsl{
    "depth/areas_stored.glsl",
#include <crease/depth/areas_stored.glsl>
};

inline constexpr glsl_file range_glsl{
    "depth/range.glsl",
#include <crease/depth/range.glsl>
};

inline constexpr glsl_file range_columns_glsl{
    "depth/range_columns.glsl",
#include <crease/depth/range_columns.glsl>
};

inline constexpr glsl_file range_join_glsl{
    "depth/range_join.glsl",
#include <crease/depth/range_join.glsl>
};

inline constexpr glsl_file range_picture_glsl{
    "depth/range_picture.glsl",
#include <crease/depth/range_picture.glsl>
};

inline constexpr glsl_file scan_glsl{
    "depth/scan.glsl",
#include <crease/depth/scan.glsl>
};

inline constexpr glsl_file scan_columns_glsl{
    "depth/scan_columns.glsl",
#include <crease/depth/scan_columns.glsl>
};

inline constexpr glsl_file scan_made_glsl{
    "depth/scan_made.glsl",
#include <crease/depth/scan_made.glsl>
};

inline constexpr glsl_file scan_rows_glsl{
    "depth/scan_rows.glsl",
#include <crease/depth/scan_rows.glsl>
};

/// What the depth sources of areas share: summed-area tables, and the steps that make them.
///
/// The tables are one array image, of which another holds the sums of the rows before; texel (i, j) of a
/// table is the sum over the texels up to and including it: x of what tells the depth, y of their count, zw
/// of the rest of what the estimator takes means of, in texels that have them. Counts are exact up to 2^24
/// texels. Places of a table are off by less than 1e-6 of its greatest sum, so small areas of large pictures
/// are the least exact. As sums of positions are centred on the mean depth, a picture of one depth has sums
/// of depth next to 0, and its mean is constant to 1e-4 of the depth at 3840 x 2160.
namespace areas {

/// The range of depth of the picture: nearest, farthest, mean, count of texels that count.
inline constexpr resource range{.name = "range",
                                .texels = format::rgba32_float,
                                .life = lifetime::transient,
                                .size = {.fixed_width = 1, .fixed_height = 1},
                                .read = access::load};
inline constexpr resource range_of_columns_image{.name = "range_of_columns",
                                                 .texels = format::rgba32_float,
                                                 .life = lifetime::transient,
                                                 .size = {.fixed_height = 1},
                                                 .read = access::load};

/// As many tables as the part has layers or levels, smaller by its divisor.
constexpr void shape_tables(resource& own, const shape_of& effect) {
    own.layers = static_cast<unsigned>(effect.own.number_of("layers", effect.own.number_of("levels", 1)));
    own.size.divisor = static_cast<unsigned>(effect.own.number_of("divisor"));
    own.texels = effect.offers(&single_area_value::value) ? format::rg32_float : format::rgba32_float;
}
constexpr resource image(std::string_view name, void (*shape)(resource&, const shape_of&) = shape_tables) {
    return {.name = name,
            .life = lifetime::transient,
            .size = {.guarded = true},
            .arrayed = true,
            .read = access::load,
            .shape = shape};
}
inline constexpr resource tables = image("area_tables");
inline constexpr resource images_of_tables[] = {tables, image("area_rows"), range, range_of_columns_image};

/// Half as many, the odd one among them.
constexpr void shape_half(resource& own, const shape_of& effect) {
    shape_tables(own, effect);
    own.layers = (own.layers + 1) / 2;
}

/// What depth sources of areas need.
using needs = traits<area_taps, area_means>;

inline constexpr role scanning[] = {role::scan};
inline constexpr std::string_view range_name[] = {"range"}, columns_name[] = {"range_of_columns"},
                                  tables_name[] = {"area_tables"}, rows_name[] = {"area_rows"};
inline constexpr const glsl_file* columns_files[] = {&range_columns_glsl, &range_join_glsl};
inline constexpr const glsl_file* picture_files[] = {&range_picture_glsl, &range_join_glsl};
inline constexpr const glsl_file* made_files[] = {&scan_glsl, &scan_made_glsl, &scan_rows_glsl};
template <const glsl_file* Read>
inline constexpr const glsl_file* row_files[] = {&scan_glsl, Read, &scan_rows_glsl};
inline constexpr const glsl_file* column_files[] = {&scan_glsl, &scan_columns_glsl};

/// What the passes and the main pass of a depth source of areas share, after its own GLSL.
template <const glsl_file* Own>
inline constexpr const glsl_file* files[] = {Own,
                                             &range_glsl,
                                             &area_texel_glsl,
                                             &area_mean_glsl,
                                             &areas_stored_glsl,
                                             &area_box_glsl,
                                             &area_query_glsl};

inline constexpr step range_of_columns{
    .name = "range_of_columns", .files = columns_files, .kind = step_kind::columns, .writes = columns_name};
inline constexpr step range_of_picture{.name = "range_of_picture",
                                       .files = picture_files,
                                       .kind = step_kind::rows,
                                       .writes = range_name,
                                       .group_width = 256,
                                       .group_height = 1};

/// A depth source of areas; what its description leaves open is the same for all.
constexpr part source(part own, array_view<const resource> resources) {
    own.resources = resources;
    own.needs = needs::list;
    own.offers = traits<layers_of_areas>::list;
    return own;
}

/// The same, of summed-area tables.
constexpr part source_of_tables(part own, array_view<const resource> resources = images_of_tables) {
    own.required_roles = scanning;
    return source(own, resources);
}

/// The workgroup of a pass that stores texels: wide and flat, as rows of a table are often as long as what
/// a cache takes for one place.
inline constexpr int wide = 64, flat = 4;

/// Stores texels; its body defines which.
constexpr step fill(std::string_view name, array_view<const glsl_file* const> body,
                    array_view<const std::string_view> writes) {
    return {.name = name,
            .files = body,
            .kind = step_kind::texels,
            .writes = writes,
            .group_width = wide,
            .group_height = flat};
}

/// The workgroups of scans, as many pieces along a line: few, as each takes its part in every step of the
/// scan of their sums. Those of rows are fewer invocations, so that few rows are spread evenly over a device.
inline constexpr int pieces_of_row = 8, rows_together = 16, pieces_of_column = flat, columns_together = wide;

/// The constants of a scan of the tables from `First` up to `End`, along the rows or the columns.
template <int First, int End, int Axis>
inline constexpr step_constant scanned[] = {
    {"first", First, "scan"}, {"end", End, "scan"}, {"axis", Axis, "scan"}};

/// Makes the sums of rows of tables; its GLSL defines of what.
constexpr step rows_of(std::string_view name, array_view<const glsl_file* const> files,
                       array_view<const step_constant> constants, int from = 0) {
    return {.name = name,
            .files = files,
            .kind = step_kind::rows,
            .constants = constants,
            .writes = rows_name,
            .group_width = pieces_of_row,
            .group_height = rows_together,
            .from = from};
}
/// Those of the picture, whose texels it makes.
inline constexpr step make_rows = rows_of("make_rows", made_files, scanned<0, 1, 0>);
/// Those of what a pass before has stored, as `Read` reads it.
template <const glsl_file* Read, int First, int End>
constexpr step sum_rows(std::string_view name, int from = 0) {
    return rows_of(name, row_files<Read>, scanned<First, End, 0>, from);
}

/// Makes tables of the sums of rows.
template <int First, int End>
constexpr step sum_columns(std::string_view name, int from = 0) {
    return {.name = name,
            .files = column_files,
            .kind = step_kind::columns,
            .constants = scanned<First, End, 1>,
            .writes = tables_name,
            .group_width = columns_together,
            .group_height = pieces_of_column,
            .from = from};
}

}

}
