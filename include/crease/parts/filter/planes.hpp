// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/output/outputs.hpp>

namespace crease {

// What filters share that weigh by tangent planes: the normal in what passes hand on, and the weights.

inline constexpr glsl_file encoding_normal_glsl{
    "encoding/normal.glsl",
#include <crease/encoding/normal.glsl>
};

inline constexpr glsl_file plane_glsl{
    "filter/plane.glsl",
#include <crease/filter/plane.glsl>
};

/// How far the weights of tangent planes reach.
constexpr setting plane_reach_setting{
    "plane_reach", 0.05f, 0, 10, "distance from a tangent plane at which a weight ends, in radii", true};

}
