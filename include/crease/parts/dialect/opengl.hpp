// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/stage/stages.hpp>

namespace crease {

/// Dialect: GLSL 430 for OpenGL 4.3 and up.
struct opengl_glsl {
    static constexpr part description{
        .kind = role::dialect,
        .name = "opengl",
        .summary = "GLSL 430 for OpenGL 4.3 and up",
        .source = "",
        .offers = traits<opengl_words>::list,
    };
};

}
