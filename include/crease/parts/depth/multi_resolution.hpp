// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/depth/layers.hpp>
#include <crease/parts/output/bent_cone.hpp>
#include <crease/parts/sampler/taps.hpp>

namespace crease {

inline constexpr glsl_file multi_resolution_glsl{
    "depth/multi_resolution.glsl",
#include <crease/depth/multi_resolution.glsl>
};

inline constexpr glsl_file multi_resolution_layers_glsl{
    "depth/multi_resolution_layers.glsl",
#include <crease/depth/multi_resolution_layers.glsl>
};

inline constexpr glsl_file multi_resolution_gather_glsl{
    "depth/multi_resolution_gather.glsl",
#include <crease/depth/multi_resolution_gather.glsl>
};

inline constexpr glsl_file multi_resolution_level_glsl{
    "depth/multi_resolution_level.glsl",
#include <crease/depth/multi_resolution_level.glsl>
};

inline constexpr glsl_file multi_resolution_odd_glsl{
    "depth/multi_resolution_odd.glsl",
#include <crease/depth/multi_resolution_odd.glsl>
};

inline constexpr glsl_file multi_resolution_even_glsl{
    "depth/multi_resolution_even.glsl",
#include <crease/depth/multi_resolution_even.glsl>
};

inline constexpr glsl_file multi_resolution_halve_glsl{
    "depth/multi_resolution_halve.glsl",
#include <crease/depth/multi_resolution_halve.glsl>
};

inline constexpr glsl_file multi_resolution_normal_glsl{
    "depth/multi_resolution_normal.glsl",
#include <crease/depth/multi_resolution_normal.glsl>
};

inline constexpr glsl_file multi_resolution_first_glsl{
    "depth/multi_resolution_first.glsl",
#include <crease/depth/multi_resolution_first.glsl>
};

inline constexpr glsl_file multi_resolution_next_glsl{
    "depth/multi_resolution_next.glsl",
#include <crease/depth/multi_resolution_next.glsl>
};

namespace multi_resolutions {

inline constexpr const glsl_file* first_files[] = {&multi_resolution_first_glsl,
                                                   &multi_resolution_halve_glsl};
inline constexpr const glsl_file* next_files[] = {&multi_resolution_next_glsl, &multi_resolution_halve_glsl};
inline constexpr const glsl_file* odd_files[] = {&multi_resolution_level_glsl, &multi_resolution_odd_glsl};
inline constexpr const glsl_file* even_files[] = {&multi_resolution_level_glsl, &multi_resolution_even_glsl};
inline constexpr std::string_view halved[] = {"resolutions"}, odd[] = {"odd_occlusion"},
                                  even[] = {"even_occlusion"};
inline constexpr step_constant levels[][1] = {{{"level", 0}}, {{"level", 1}}, {{"level", 2}},
                                              {{"level", 3}}, {{"level", 4}}, {{"level", 5}}};

/// The pass that gathers in the picture that is halved `level` times, where there is one.
constexpr step gather(std::string_view name, unsigned level) {
    step own{.name = name,
             .files = even_files,
             .kind = step_kind::texels,
             .constants = levels[level],
             .writes = even,
             .from = static_cast<int>(level) + 1,
             .level = level};
    if (level % 2 == 1) {
        own.files = odd_files;
        own.writes = odd;
    }
    return own;
}

/// An image with a mip level for each resolution.
constexpr resource image(std::string_view name, format texels) {
    return {.name = name,
            .texels = texels,
            .life = lifetime::transient,
            .size = {.guarded = true},
            .shape = [](resource& own, const shape_of& effect) {
                own.levels = static_cast<unsigned>(effect.own.number_of("levels"));
            }};
}

/// The same for what passes hand on: the coarsest finds nothing there.
constexpr resource occlusion(std::string_view name) {
    resource own = image(name, format::r32_uint);
    own.cleared = true;
    return own;
}

}

struct multi_resolution_part {
    using needs = traits<screen_taps>;
    static constexpr number takes[] = {
        {"levels", 2, 6, 4, "resolutions, each half of the one before; fewer where the picture has no more"},
        {"reach", 1, 64, 5, "how far taps reach, texels of their resolution; at most the radius"}};
    static constexpr setting reads[] = {
        {"step", 0.25f, 0, 100, "difference in depth up to which four texels are one surface, radii"}};
    static constexpr resource images[] = {multi_resolutions::image("resolutions", format::rgba32_uint),
                                          multi_resolutions::occlusion("odd_occlusion"),
                                          multi_resolutions::occlusion("even_occlusion")};
    static constexpr step passes[] = {{.name = "halve_picture",
                                       .files = multi_resolutions::first_files,
                                       .kind = step_kind::texels,
                                       .writes = multi_resolutions::halved,
                                       .level = 1},
                                      {.name = "halve_again",
                                       .files = multi_resolutions::next_files,
                                       .kind = step_kind::texels,
                                       .writes = multi_resolutions::halved,
                                       .level = 2,
                                       .further_levels = true},
                                      multi_resolutions::gather("gather_5", 5),
                                      multi_resolutions::gather("gather_4", 4),
                                      multi_resolutions::gather("gather_3", 3),
                                      multi_resolutions::gather("gather_2", 2),
                                      multi_resolutions::gather("gather_1", 1)};
    static constexpr const glsl_file* files[] = {&multi_resolution_glsl, &multi_resolution_layers_glsl,
                                                 &multi_resolution_gather_glsl, &multi_resolution_normal_glsl,
                                                 &encoding_octahedron_glsl};
    static constexpr part description{
        .kind = role::depth_source,
        .name = "multi_resolution",
        .summary = "the depth buffer in several resolutions, each of which gives an occlusion: MSSAO",
        .source =
            "Hoang and Low 2010, Multi-Resolution Screen-Space Ambient Occlusion; a-buffer-ssao 2013, V.A",
        .files = files,
        .numbers = takes,
        .settings = reads,
        .resources = images,
        .steps = passes,
        .needs = needs::list,
        .offers = traits<depth_layers>::list,
    };
};

/// Depth source: the depth image of the receivers in at most `Levels` resolutions, one layer. Each resolution
/// gathers by itself, from the coarsest to that of the picture, with taps that reach `Reach` of its texels,
/// and takes over what the coarser ones found by an upsampling that keeps to surfaces. Of all of them the
/// greatest and the mean count, 1 - (1 - greatest) (1 - mean). So few taps see far, and noise is not needed:
/// `tap_grid`.
///
/// Published with the mean of taps that `hbao_plus` takes, with the bias 0; what an output holds beside
/// visibility is of the picture's own resolution.
template <int Levels = 4, int Reach = 5>
struct multi_resolution : multi_resolution_part {
    static constexpr int numbers[] = {Levels, Reach};
};

}
