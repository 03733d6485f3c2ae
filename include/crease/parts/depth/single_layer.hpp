// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/depth/layers.hpp>

namespace crease {

inline constexpr glsl_file single_layer_glsl{
    "depth/single_layer.glsl",
#include <crease/depth/single_layer.glsl>
};

/// Depth source: the depth image of the receivers, one layer.
struct single_layer {
    static constexpr const glsl_file* files[] = {&single_layer_glsl};
    static constexpr part description{
        .kind = role::depth_source,
        .name = "single_layer",
        .summary = "the depth buffer: what the camera sees first",
        .source = "stochastic-depth-ao 2020, ch. 4",
        .files = files,
        .offers = traits<depth_layers>::list,
    };
};

}
