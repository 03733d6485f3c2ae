// SPDX-License-Identifier: MIT
#pragma once

#include <crease/compose/part.hpp>
#include <crease/parts/output/outputs.hpp>

namespace crease {

// What filters share that weigh by tangent planes and normals.

inline constexpr glsl_file normal_glsl{
    "encoding/normal.glsl",
#include <crease/encoding/normal.glsl>
};

inline constexpr glsl_file plane_weight_glsl{
    "filter/plane_weight.glsl",
#include <crease/filter/plane_weight.glsl>
};

constexpr setting plane_reach_setting{
    "plane_reach", 0.05f, 0, 10, "distance from the tangent plane at which a weight ends, in radii", true};

}
