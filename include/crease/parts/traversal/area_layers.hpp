// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/depth/layers.hpp>

namespace crease {

inline constexpr glsl_file area_layers_glsl{
    "traversal/area_layers.glsl",
#include <crease/traversal/area_layers.glsl>
};

/// Layer traversal: the layers of an area, each of which counts by how many texels it holds. The default of
/// depth sources of areas.
struct area_layers {
    using needs = traits<layers_of_areas>;
    static constexpr const glsl_file* files[] = {&area_layers_glsl};
    static constexpr part description{
        .kind = role::layer_traversal,
        .name = "area_layers",
        .summary = "counts each layer of an area by the number of its texels",
        .source = "statistical-volumetric-obscurance 2015, 4.3, (4.4)",
        .files = files,
        .needs = needs::list,
    };
};

}
