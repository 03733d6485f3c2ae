// SPDX-License-Identifier: MIT
#pragma once

#include <crease/part.hpp>

namespace crease {

/// Layers of depth that can be told one by one.
CREASE_TRAIT(depth_layers, depth_source,
             "single layers of depth are needed, which the depth source does not hold");

/// Layers of two cameras.
CREASE_TRAIT(layers_of_two_views, depth_source,
             "the second view needs layers of two cameras, and the depth source holds those of one");

/// The fold of the layered papers: the layer that occludes the most counts for the tap.
inline constexpr glsl_file fold_max_glsl{
    "core/fold_max.glsl",
#include <crease/core/fold_max.glsl>
};

}
