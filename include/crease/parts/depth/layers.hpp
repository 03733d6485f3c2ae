// SPDX-License-Identifier: MIT
#pragma once

#include <crease/compose/part.hpp>

namespace crease {

/// Layers of depth that can be told one by one.
CREASE_TRAIT(depth_layers, depth_source,
             "single layers of depth are needed, which the depth source does not hold");

/// Layers behind that of the depth image.
CREASE_TRAIT(layers_behind_front, depth_source,
             "the layer traversal looks behind the front surface, and the depth source holds nothing there");

/// Layers of two cameras.
CREASE_TRAIT(layers_of_two_views, depth_source,
             "the second view needs layers of two cameras, and the depth source holds those of one");

/// Means over areas of the picture, layer by layer.
CREASE_TRAIT(layers_of_areas, depth_source,
             "the sampler proposes areas, and the depth source holds no means over them");

}
