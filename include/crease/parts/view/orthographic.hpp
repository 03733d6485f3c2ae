// SPDX-License-Identifier: MIT
#pragma once

#include <crease/compose/part.hpp>

namespace crease {

inline constexpr glsl_file orthographic_glsl{
    "view/orthographic.glsl",
#include <crease/view/orthographic.glsl>
};

/// Projection: orthographic, centred or not.
struct orthographic {
    static constexpr const glsl_file* files[] = {&orthographic_glsl};
    static constexpr part description{
        .kind = role::projection,
        .name = "orthographic",
        .summary = "an orthographic projection; device depth standard or reversed",
        .source = "stochastic-depth-ao 2020, 4.4",
        .files = files,
    };
};

}
