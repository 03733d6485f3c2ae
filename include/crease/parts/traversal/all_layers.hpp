// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/depth/layers.hpp>

namespace crease {

inline constexpr glsl_file all_layers_glsl{
    "traversal/all_layers.glsl",
#include <crease/traversal/all_layers.glsl>
};

/// Reads the layers of the depth source alone, so it works for any camera.
CREASE_TRAIT(any_view, layer_traversal,
             "the second view needs a layer traversal that looks at no depth image, as there is none of the "
             "second camera");

/// Takes every layer from the depth source, the front one too.
CREASE_TRAIT(
    layers_alone, layer_traversal,
    "layers are weighed by their opacity, and the layer traversal takes the front one from the depth "
    "image, which tells none");

/// Layer traversal: all layers of every tap, combined by the estimator. The default.
struct all_layers {
    using needs = traits<depth_layers>;
    static constexpr const glsl_file* files[] = {&all_layers_glsl};
    static constexpr part description{
        .kind = role::layer_traversal,
        .name = "all_layers",
        .summary = "looks at all layers of every tap",
        .source = "stochastic-depth-ao 2020, 6.2",
        .files = files,
        .needs = needs::list,
        .offers = traits<any_view, layers_alone>::list,
    };
};

}
