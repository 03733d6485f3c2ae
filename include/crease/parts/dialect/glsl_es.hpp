// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/dialect/dialects.hpp>

namespace crease {

inline constexpr glsl_file glsl_es_300_glsl{
    "dialect/glsl_es_300.glsl",
#include <crease/dialect/glsl_es_300.glsl>
};

struct glsl_es_part {
    static constexpr number takes[] = {
        {"version", 300, 310, 310, "300 for WebGL 2 and OpenGL ES 3.0, 310 for OpenGL ES 3.1 and up"}};
    static constexpr const glsl_file* files[] = {&view_set_in_main_glsl};
    static constexpr part description{
        .kind = role::dialect,
        .name = "glsl_es",
        .summary = "GLSL ES for OpenGL ES and WebGL 2",
        .source = "",
        .files = files,
        .numbers = takes,
        .offers = traits<glsl_es_words>::list,
    };
};

/// Dialect: GLSL ES. Version 300, of WebGL 2, has neither compute shaders nor bindings: an effect has the
/// stage `fragment` or `functions`, no pass but those that hand a result on, and a host finds uniforms by
/// their names. Version 310 has both; what its compute shaders store has a format that every device can
/// store: `rgba8_unorm` in place of `r8_unorm`, and four components in place of two.
template <int Version = 310>
struct glsl_es : glsl_es_part {
    static constexpr int numbers[] = {Version};
};

}
