// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/depth/packed_layers.hpp>

namespace crease {

inline constexpr glsl_file stochastic_layers_glsl{
    "depth/stochastic_layers.glsl",
#include <crease/depth/stochastic_layers.glsl>
};

inline constexpr glsl_file pack_layers_glsl{
    "depth/pack_layers.glsl",
#include <crease/depth/pack_layers.glsl>
};

struct stochastic_layers_part {
    static constexpr number takes[] = {
        {"count", 1, 32, 8, "samples of a texel, each of which keeps one layer"}};
    static constexpr resource packed[] = {packed_layers};
    static constexpr role required[] = {role::layer_storage, role::coverage};
    static constexpr const glsl_file* packing[] = {&pack_layers_glsl};
    static constexpr std::string_view filled[] = {"packed_layers"};
    static constexpr step passes[] = {{.name = "pack_layers",
                                       .files = packing,
                                       .kind = step_kind::texels,
                                       .writes = filled,
                                       .per_view = true}};
    static constexpr const glsl_file* files[] = {&stochastic_layers_glsl, &packed_layers_glsl};
    static constexpr part description{
        .kind = role::depth_source,
        .name = "stochastic_layers",
        .summary = "layers behind the first, kept at random as if all surfaces were transparent",
        .source = "stochastic-depth-ao 2020, ch. 5 and 6, Algorithms 4 to 9",
        .files = files,
        .widened = packed_layers_widened,
        .numbers = takes,
        .resources = packed,
        .steps = passes,
        .offers = traits<depth_layers, layers_behind_front, layers_of_two_views, layers_in_strips>::list,
        .required_roles = required,
    };
};

/// Depth source: `Count` samples a texel, each of which keeps the nearest of the fragments that a coin of the
/// setting `opacity` gives it. Receivers come from the depth image.
template <int Count = 8>
struct stochastic_layers : stochastic_layers_part {
    static constexpr int numbers[] = {Count};
};

}
