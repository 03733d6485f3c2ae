// SPDX-License-Identifier: MIT
#pragma once

#include <crease/part.hpp>

namespace crease {

inline constexpr glsl_file functions_glsl{
    "stage/functions.glsl",
#include <crease/stage/functions.glsl>
};

struct functions_part {
    static constexpr number takes[] = {
        {"set", 0, 31, 0, "descriptor set of all bindings", false},
        {"first_binding", 0, 1023, 0, "binding of the block of parameters; the others follow", false},
        {"first_constant", 0, 1023, 0, "constant_id of the first number; the others follow", false},
    };
    static constexpr part description{
        .kind = role::stage,
        .name = "functions",
        .summary =
            "no main: float crease_visibility(ivec2 pixel) and what it needs, for a shader of the host",
        .source = "",
        .glsl = &functions_glsl,
        .numbers = takes,
        .stage_of = stage_kind::functions,
    };
};

/// Stage: functions for the host's own shader, which states `#version` and places them by these numbers.
template <int Set = 0, int FirstBinding = 0, int FirstConstant = 0>
struct functions : functions_part {
    static constexpr int numbers[] = {Set, FirstBinding, FirstConstant};
};

}
