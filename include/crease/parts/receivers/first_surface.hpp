// SPDX-License-Identifier: MIT
#pragma once

#include <crease/compose/part.hpp>

namespace crease {

inline constexpr glsl_file first_surface_glsl{
    "receivers/first_surface.glsl",
#include <crease/receivers/first_surface.glsl>
};

/// Receivers: the surface that the depth image holds. The default.
struct first_surface {
    static constexpr const glsl_file* files[] = {&first_surface_glsl};
    static constexpr part description{
        .kind = role::receivers,
        .name = "first_surface",
        .summary = "the surface that the camera sees first",
        .source = "stochastic-depth-ao 2020, ch. 4",
        .files = files,
    };
};

}
