// SPDX-License-Identifier: MIT
#pragma once

#include <crease/compose/part.hpp>

namespace crease {

inline constexpr glsl_file perspective_glsl{
    "view/perspective.glsl",
#include <crease/view/perspective.glsl>
};

/// Projection: perspective, centred or not. The default.
struct perspective {
    static constexpr const glsl_file* files[] = {&perspective_glsl};
    static constexpr part description{
        .kind = role::projection,
        .name = "perspective",
        .summary = "a perspective projection; device depth standard, reversed or infinite",
        .source = "stochastic-depth-ao 2020, 4.4",
        .files = files,
    };
};

}
