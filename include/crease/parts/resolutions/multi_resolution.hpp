// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/compression/nodes.hpp>
#include <crease/parts/depth/surfaces.hpp>
#include <crease/parts/receivers/thin_layers.hpp>
#include <crease/parts/sampler/taps.hpp>

namespace crease {

inline constexpr glsl_file multi_resolution_glsl{
    "resolutions/multi_resolution.glsl",
#include <crease/resolutions/multi_resolution.glsl>
};

inline constexpr glsl_file multi_resolution_layers_glsl{
    "resolutions/multi_resolution_layers.glsl",
#include <crease/resolutions/multi_resolution_layers.glsl>
};

inline constexpr glsl_file multi_resolution_gather_glsl{
    "resolutions/multi_resolution_gather.glsl",
#include <crease/resolutions/multi_resolution_gather.glsl>
};

inline constexpr glsl_file multi_resolution_level_glsl{
    "resolutions/multi_resolution_level.glsl",
#include <crease/resolutions/multi_resolution_level.glsl>
};

inline constexpr glsl_file multi_resolution_odd_glsl{
    "resolutions/multi_resolution_odd.glsl",
#include <crease/resolutions/multi_resolution_odd.glsl>
};

inline constexpr glsl_file multi_resolution_even_glsl{
    "resolutions/multi_resolution_even.glsl",
#include <crease/resolutions/multi_resolution_even.glsl>
};

inline constexpr glsl_file multi_resolution_halve_glsl{
    "resolutions/multi_resolution_halve.glsl",
#include <crease/resolutions/multi_resolution_halve.glsl>
};

inline constexpr glsl_file multi_resolution_layer_glsl{
    "resolutions/multi_resolution_layer.glsl",
#include <crease/resolutions/multi_resolution_layer.glsl>
};

inline constexpr glsl_file multi_resolution_depths_glsl{
    "resolutions/multi_resolution_depths.glsl",
#include <crease/resolutions/multi_resolution_depths.glsl>
};

inline constexpr glsl_file multi_resolution_opacities_glsl{
    "resolutions/multi_resolution_opacities.glsl",
#include <crease/resolutions/multi_resolution_opacities.glsl>
};

inline constexpr glsl_file multi_resolution_surfaces_glsl{
    "resolutions/multi_resolution_surfaces.glsl",
#include <crease/resolutions/multi_resolution_surfaces.glsl>
};

inline constexpr glsl_file multi_resolution_first_glsl{
    "resolutions/multi_resolution_first.glsl",
#include <crease/resolutions/multi_resolution_first.glsl>
};

inline constexpr glsl_file multi_resolution_next_glsl{
    "resolutions/multi_resolution_next.glsl",
#include <crease/resolutions/multi_resolution_next.glsl>
};

namespace multi_resolutions {

inline constexpr const glsl_file* first_files[] = {&multi_resolution_first_glsl,
                                                   &multi_resolution_halve_glsl};
inline constexpr const glsl_file* next_files[] = {&multi_resolution_next_glsl, &multi_resolution_halve_glsl};
inline constexpr const glsl_file* odd_files[] = {&multi_resolution_level_glsl, &multi_resolution_odd_glsl,
                                                 &multi_resolution_layers_glsl};
inline constexpr const glsl_file* even_files[] = {&multi_resolution_level_glsl, &multi_resolution_even_glsl,
                                                  &multi_resolution_layers_glsl};
inline constexpr std::string_view halved[] = {"resolutions"}, odd[] = {"odd_occlusion"},
                                  even[] = {"even_occlusion"};
inline constexpr step_constant levels[][1] = {{{"level", 0}}, {{"level", 1}}, {{"level", 2}},
                                              {{"level", 3}}, {{"level", 4}}, {{"level", 5}}};

/// The pass that gathers in the picture that is halved `times` times, where there is one.
constexpr step gather(std::string_view name, unsigned times) {
    step own{.name = name,
             .files = even_files,
             .kind = step_kind::texels,
             .constants = levels[times],
             .writes = even,
             .from = static_cast<int>(times) + 1,
             .level = times - 1};
    if (times % 2 == 1) {
        own.files = odd_files;
        own.writes = odd;
    }
    return own;
}

/// How many layers of a texel are kept of the depth source: those that receivers may find.
constexpr unsigned layers_of(const shape_of& effect) {
    const int all =
        effect.number_of(role::depth_source, "layers", effect.offers(&layers_behind_front::value) ? 2 : 1);
    const choice* const fewer = effect.find(role::layer_compression);
    const bool are_fewer = fewer && !has(fewer->what->offers, &all_surfaces::value);
    return static_cast<unsigned>(are_fewer ? fewer->number_of("nodes", all) : all);
}

/// A mip level for each resolution below the picture's, and one more where there would be one, of which GLSL
/// would not ask by its level.
constexpr void shape_resolutions(resource& own, const shape_of& effect) {
    const int smaller = effect.own.number_of("levels") - 1;
    own.levels = smaller > 1 ? static_cast<unsigned>(smaller) : 2;
    own.layers = layers_of(effect);
}

/// The same for each layer that receives, and where both sides of it do, for each side.
constexpr void shape_occlusion(resource& own, const shape_of& effect) {
    shape_resolutions(own, effect);
    if (!effect.offers(&blended_layers::value))
        own.layers = 1;
    else if (effect.needs(&both_sides::value))
        own.layers *= 2;
}

/// Layers of a texel in the smaller pictures.
inline constexpr resource resolutions{.name = "resolutions",
                                      .texels = format::rgba32_uint,
                                      .life = lifetime::transient,
                                      .size = {.guarded = true, .level = 1},
                                      .arrayed = true,
                                      .shape = shape_resolutions};

/// What passes hand on: the coarsest finds nothing there.
constexpr resource occlusion(std::string_view name) {
    return {.name = name,
            .texels = format::r32_uint,
            .life = lifetime::transient,
            .size = {.guarded = true, .level = 1},
            .arrayed = true,
            .cleared = true,
            .shape = shape_occlusion};
}

}

struct multi_resolution_part {
    using needs = traits<screen_taps, sorted_layers>;
    static constexpr number takes[] = {
        {"levels", 2, 6, 4, "resolutions, each half of the one before; fewer where the picture has no more"},
        {"reach", 1, 64, 5, "how far taps reach, texels of their resolution; at most the radius"}};
    static constexpr setting reads[] = {
        {"step", 0.25f, 0, 100, "difference in depth up to which four texels are one surface, radii"}};
    static constexpr resource images[] = {multi_resolutions::resolutions,
                                          multi_resolutions::occlusion("odd_occlusion"),
                                          multi_resolutions::occlusion("even_occlusion")};
    static constexpr step passes[] = {{.name = "halve_picture",
                                       .files = multi_resolutions::first_files,
                                       .kind = step_kind::texels,
                                       .writes = multi_resolutions::halved},
                                      {.name = "halve_again",
                                       .files = multi_resolutions::next_files,
                                       .kind = step_kind::texels,
                                       .writes = multi_resolutions::halved,
                                       .from = 3,
                                       .level = 1,
                                       .further_levels = true},
                                      multi_resolutions::gather("gather_5", 5),
                                      multi_resolutions::gather("gather_4", 4),
                                      multi_resolutions::gather("gather_3", 3),
                                      multi_resolutions::gather("gather_2", 2),
                                      multi_resolutions::gather("gather_1", 1)};
    static constexpr const glsl_file* files[] = {&multi_resolution_glsl,        &multi_resolution_gather_glsl,
                                                 &multi_resolution_layer_glsl,  &multi_resolution_depths_glsl,
                                                 &encoding_surface_normal_glsl, &encoding_octahedron_glsl};
    static constexpr const glsl_file* of_surfaces[] = {&multi_resolution_surfaces_glsl};
    static constexpr const glsl_file* of_opacities[] = {&multi_resolution_opacities_glsl};
    static constexpr files_where more[] = {{&layers_with_normals::value, of_surfaces},
                                           {&layers_with_opacity::value, of_opacities}};
    static constexpr part description{
        .kind = role::resolutions,
        .name = "multi_resolution",
        .summary =
            "the picture and its layers in several resolutions, each of which gives an occlusion: MSSAO",
        .source =
            "Hoang and Low 2010, Multi-Resolution Screen-Space Ambient Occlusion; a-buffer-ssao 2013, V.A",
        .files = files,
        .widened = more,
        .numbers = takes,
        .settings = reads,
        .resources = images,
        .steps = passes,
        .needs = needs::list,
    };
};

/// Resolutions: the layers of the depth source in at most `Levels` resolutions. Each gathers by itself, from
/// the coarsest to that of the picture, with taps that reach `Reach` of its texels, and takes over what the
/// coarser ones found by an upsampling that keeps to surfaces. Of all of them the greatest and the mean
/// count, 1 - (1 - greatest) (1 - mean). So few taps see far, and noise is not needed: `tap_grid`.
///
/// Layers are halved by their order from the eye, and every receiver of a texel is one in each resolution.
///
/// Published of a single layer, with the mean of taps that `hbao_plus` takes, with the bias 0; what an output
/// holds beside visibility is of the picture's own resolution.
template <int Levels = 4, int Reach = 5>
struct multi_resolution : multi_resolution_part {
    static constexpr int numbers[] = {Levels, Reach};
};

}
