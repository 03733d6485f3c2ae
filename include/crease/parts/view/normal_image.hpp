// SPDX-License-Identifier: MIT
#pragma once

#include <crease/compose/part.hpp>

namespace crease {

inline constexpr glsl_file unit_normal_glsl{
    "view/unit_normal.glsl",
#include <crease/view/unit_normal.glsl>
};

inline constexpr glsl_file view_space_glsl{
    "view/view_space.glsl",
#include <crease/view/view_space.glsl>
};

/// The input of the parts that are given normals. Such a part defines `vec3 crease_stored_normal(vec2
/// texel)`.
/// @param content  what it holds: see `resource::content`
constexpr resource normal_image(std::string_view content, format texels) {
    return {.name = "normal", .texels = texels, .size = {.guarded = true}, .content = content};
}

}
