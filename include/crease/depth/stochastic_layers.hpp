// SPDX-License-Identifier: MIT
#pragma once

#include <crease/depth/layers.hpp>

namespace crease {

inline constexpr glsl_file stochastic_layers_glsl{
    "depth/stochastic_layers.glsl",
#include <crease/depth/stochastic_layers.glsl>
};

inline constexpr glsl_file layer_groups_glsl{
    "depth/layer_groups.glsl",
#include <crease/depth/layer_groups.glsl>
};

inline constexpr glsl_file pack_layers_glsl{
    "depth/pack_layers.glsl",
#include <crease/depth/pack_layers.glsl>
};

struct stochastic_layers_part {
    static constexpr number takes[] = {
        {"count", 1, 32, 8, "samples of a texel, each of which keeps one layer"}};
    static constexpr setting reads[] = {
        {"opacity", &parameters::opacity, 0.2f, 0.001f, 1,
         "probability that a sample keeps a fragment, alpha"},
    };
    static constexpr const glsl_file* groups[] = {&layer_groups_glsl};
    static constexpr role capturing[] = {role::layer_carrier, role::layer_sampling, role::fold};
    static constexpr format few[] = {format::r32_float, format::rg32_float};
    static constexpr resource packed[] = {{.name = "packed_layers",
                                           .texels = format::rgba32_float,
                                           .life = lifetime::transient,
                                           .size = {.guarded = true},
                                           .arrayed = true,
                                           .read = access::load,
                                           .layers_by = {.number = 0, .share = 4},
                                           .texels_of_few = few}};
    static constexpr role packing[] = {role::projection, role::depth_encoding, role::layer_carrier};
    static constexpr std::string_view filled[] = {"packed_layers"};
    static constexpr step passes[] = {{.name = "pack_layers",
                                       .body = &pack_layers_glsl,
                                       .kind = step_kind::build,
                                       .includes = packing,
                                       .helpers = groups,
                                       .writes = filled}};
    static constexpr part description{
        .kind = role::depth_source,
        .name = "stochastic_layers",
        .summary = "layers behind the first, kept at random as if all surfaces were transparent",
        .source = "stochastic-depth-ao 2020, ch. 5 and 6, Algorithms 4 to 9",
        .glsl = &stochastic_layers_glsl,
        .helpers = groups,
        .numbers = takes,
        .settings = reads,
        .offers = traits<depth_layers, layers_of_two_views>::list,
        .wants = capturing,
        .resources = packed,
        .steps = passes,
    };
};

/// Depth source: `Count` samples a texel, each of which keeps the nearest of the fragments that a coin of the
/// setting `opacity` gives it. Receivers come from the depth image.
template <int Count = 8>
struct stochastic_layers : stochastic_layers_part {
    static constexpr int numbers[] = {Count};
};

}
