// SPDX-License-Identifier: MIT
#pragma once

#include <crease/part.hpp>

namespace crease {

/// Dialect: GLSL 430 for OpenGL 4.3 and up.
struct opengl_glsl {
    static constexpr part description{
        .kind = role::dialect,
        .name = "opengl",
        .summary = "GLSL 430 for OpenGL 4.3 and up",
        .source = "",
        .dialect_of = dialect_kind::opengl,
    };
};

}
