// SPDX-License-Identifier: MIT
#pragma once

#include <crease/compose/part.hpp>

namespace crease {

inline constexpr glsl_file reconstructed_normals_glsl{
    "view/reconstructed_normals.glsl",
#include <crease/view/reconstructed_normals.glsl>
};

/// Normals: reconstructed from the depth image, by the nearer of the neighbours left and right, and up and
/// down.
struct reconstructed_normals {
    static constexpr const glsl_file* files[] = {&reconstructed_normals_glsl};
    static constexpr part description{
        .kind = role::normals,
        .name = "reconstructed_normals",
        .summary = "normals are reconstructed from the depth of the neighbours",
        .source = "stochastic-depth-ao 2020, 4.4",
        .files = files,
    };
};

}
