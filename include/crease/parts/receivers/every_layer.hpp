// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/receivers/surfaces.hpp>

namespace crease {

inline constexpr glsl_file every_layer_glsl{
    "receivers/every_layer.glsl",
#include <crease/receivers/every_layer.glsl>
};

/// Receivers: every layer that the depth source keeps of a texel, merged by opacity. Surfaces are those of
/// solids: the hemisphere of the side that is seen counts.
struct every_layer {
    using needs = traits<layers_with_opacity, layers_with_normals, layers_alone>;
    static constexpr const glsl_file* files[] = {&every_layer_glsl, &surfaces_glsl};
    static constexpr part description{
        .kind = role::receivers,
        .name = "every_layer",
        .summary = "every layer, as surfaces of solids, merged by opacity",
        .source = "a-buffer-ssao 2013, III, (1)",
        .files = files,
        .needs = needs::list,
        .offers = traits<blended_layers>::list,
    };
};

}
