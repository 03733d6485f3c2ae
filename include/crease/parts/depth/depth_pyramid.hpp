// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/depth/single_layer.hpp>
#include <crease/parts/sampler/taps.hpp>

namespace crease {

inline constexpr glsl_file depth_pyramid_glsl{
    "depth/depth_pyramid.glsl",
#include <crease/depth/depth_pyramid.glsl>
};

inline constexpr glsl_file depth_pyramid_base_glsl{
    "depth/depth_pyramid_base.glsl",
#include <crease/depth/depth_pyramid_base.glsl>
};

inline constexpr glsl_file depth_pyramid_level_glsl{
    "depth/depth_pyramid_level.glsl",
#include <crease/depth/depth_pyramid_level.glsl>
};

struct depth_pyramid_part {
    using needs = traits<movable_taps>;
    static constexpr number takes[] = {
        {"levels", 2, 12, 6, "mip levels, fewer where the picture has no more"},
        {"nearest", 0, 1, 0, "a texel of a level holds of four texels 0: the first; 1: the nearest"}};

    static constexpr void shape(resource& own, const shape_of& effect) {
        own.levels = static_cast<unsigned>(effect.own.number_of("levels"));
    }
    static constexpr resource images[] = {{.name = "depth_pyramid",
                                           .texels = format::r32_float,
                                           .life = lifetime::transient,
                                           .size = {.guarded = true},
                                           .shape = shape}};
    static constexpr std::string_view filled[] = {"depth_pyramid"};
    static constexpr const glsl_file* base_files[] = {&depth_pyramid_base_glsl};
    static constexpr const glsl_file* level_files[] = {&depth_pyramid_level_glsl};
    static constexpr step passes[] = {
        {.name = "depth_pyramid_base", .files = base_files, .kind = step_kind::texels, .writes = filled},
        {.name = "depth_pyramid_level",
         .files = level_files,
         .kind = step_kind::texels,
         .writes = filled,
         .level = 1,
         .further_levels = true}};
    static constexpr const glsl_file* files[] = {&depth_pyramid_glsl, &single_layer_glsl};
    static constexpr part description{
        .kind = role::depth_source,
        .name = "depth_pyramid",
        .summary = "the depth buffer in mip levels: each tap reads the level that suits the spacing of taps",
        .source = "scalable ambient obscurance 2012, 2.3; XeGTAO 1.30",
        .files = files,
        .numbers = takes,
        .resources = images,
        .steps = passes,
        .needs = needs::list,
        .offers = traits<depth_layers>::list,
    };
};

/// Depth source: the depth image of the receivers in at most `Levels` mip levels, one layer. With texels a
/// quarter as large as the spacing of taps the cost of a tap is bounded at any radius.
///
/// With the first of four texels a tap is one of `single_layer`, moved by an eighth of their spacing at the
/// most. With the nearest it stands for all that lies in its texel, in whose middle it is, so slanted planes
/// are not quite unoccluded: for radii of many hundred texels and few taps. Drivers that run on processors
/// take half as long again as for `single_layer`; it is for GPUs.
template <int Levels = 6, int Nearest = 0>
struct depth_pyramid : depth_pyramid_part {
    static constexpr int numbers[] = {Levels, Nearest};
};

}
