// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/view/normal_image.hpp>

namespace crease {

inline constexpr glsl_file octahedral_normals_glsl{
    "view/octahedral_normals.glsl",
#include <crease/view/octahedral_normals.glsl>
};

/// Normals: an image of view-space normals that face the camera, each the point of an octahedron, packed to
/// [0, 1]: x and y divided by |x| + |y| + |z|, folded over where z is negative, and p / 2 + 1 / 2 of that.
struct octahedral_normals {
    static constexpr resource inputs[] = {normal_image("octahedral_view_normals", format::rg32_float)};
    static constexpr const glsl_file* files[] = {&octahedral_normals_glsl, &unit_normal_glsl,
                                                 &view_space_glsl};
    static constexpr part description{
        .kind = role::normals,
        .name = "octahedral_normals",
        .summary = "an image holds view-space normals as points of an octahedron, packed to [0, 1]",
        .source = "Cigolle et al. 2014",
        .files = files,
        .resources = inputs,
    };
};

}
