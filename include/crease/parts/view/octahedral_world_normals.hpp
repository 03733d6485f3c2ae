// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/view/octahedral_normals.hpp>
#include <crease/parts/view/world_space.hpp>

namespace crease {

/// Normals: an image of world-space normals that face the camera, as octahedral_normals has those of view
/// space. The host sets the rotation to view space: see set_world_to_view.
struct octahedral_world_normals {
    static constexpr resource inputs[] = {normal_image("octahedral_world_normals", format::rg32_float)};
    static constexpr const glsl_file* files[] = {&octahedral_normals_glsl, &unit_normal_glsl,
                                                 &world_space_glsl};
    static constexpr part description{
        .kind = role::normals,
        .name = "octahedral_world_normals",
        .summary = "an image holds world-space normals as points of an octahedron, packed to [0, 1]",
        .source = "Cigolle et al. 2014",
        .files = files,
        .settings = world_settings,
        .resources = inputs,
    };
};

}
