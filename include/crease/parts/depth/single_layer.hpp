// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/depth/layers.hpp>

namespace crease {

inline constexpr glsl_file single_layer_glsl{
    "depth/single_layer.glsl",
#include <crease/depth/single_layer.glsl>
};

inline constexpr glsl_file single_layer_strips_glsl{
    "depth/single_layer_strips.glsl",
#include <crease/depth/single_layer_strips.glsl>
};

/// Depth source: the depth image of the receivers, one layer.
struct single_layer {
    static constexpr const glsl_file* files[] = {&single_layer_glsl};
    static constexpr const glsl_file* in_strips[] = {&single_layer_strips_glsl};
    static constexpr files_where more[] = {{&layers_in_strips::value, in_strips}};
    static constexpr part description{
        .kind = role::depth_source,
        .name = "single_layer",
        .summary = "the depth buffer: what the camera sees first",
        .source = "stochastic-depth-ao 2020, ch. 4",
        .files = files,
        .widened = more,
        .offers = traits<depth_layers, sorted_layers, layers_in_strips>::list,
    };
};

}
