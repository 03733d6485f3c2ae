// SPDX-License-Identifier: MIT
#pragma once

#include <crease/compose/part.hpp>

namespace crease {

/// Layers of depth that can be told one by one.
CREASE_TRAIT(depth_layers, depth_source,
             "single layers of depth are needed, which the depth source does not hold");

/// Layers in order, the nearest first: as many as the number `layers` of the source says; of one without that
/// number one, or two with layers_behind_front.
CREASE_TRAIT(sorted_layers, depth_source,
             "the resolutions take layers in order from the eye, and the depth source keeps them in none");

/// Layers behind that of the depth image.
CREASE_TRAIT(layers_behind_front, depth_source,
             "the layer traversal looks behind the front surface, and the depth source holds nothing there");

/// Layers of two cameras.
CREASE_TRAIT(layers_of_two_views, depth_source,
             "the second view needs layers of two cameras, and the depth source holds those of one");

/// Layers with normal, colour and opacity: they are captured by
/// `void crease_capture(vec3 anchor, vec3 normal, vec4 color)` where a part needs it.
CREASE_TRAIT(layers_with_opacity, depth_source,
             "layers are needed with their opacity, and the depth source keeps depths alone");

/// Layers with normals for receivers, which a source with opacity need not keep where no part needs it.
CREASE_TRAIT(layers_with_normals, depth_source,
             "the receivers are layers, and the depth source keeps no normals of them");

/// Layers that the stage may keep in shared memory, along the rows and columns of a workgroup: where a part
/// needs it, `void crease_keep_in_strips(int place, vec2 texel)` keeps those of a texel, one of a source with
/// nothing behind the front and else the nearest four, and taps look for theirs by
/// `int crease_strips_place(vec2 texel)`.
CREASE_TRAIT(layers_in_strips, depth_source,
             "the stage keeps layers in shared memory, where the depth source does not look for them");

/// Finds layers in the resolution of the depth image alone.
CREASE_TRAIT(one_resolution, resolutions,
             "layers are looked for in the depth image or in shared memory, which have one resolution, and "
             "there are several");

/// Means over areas of the picture, layer by layer.
CREASE_TRAIT(layers_of_areas, depth_source,
             "the sampler proposes areas, and the depth source holds no means over them");

}
