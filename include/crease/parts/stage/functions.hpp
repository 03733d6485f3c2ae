// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/stage/stages.hpp>

namespace crease {

inline constexpr glsl_file functions_glsl{
    "stage/functions.glsl",
#include <crease/stage/functions.glsl>
};

struct functions_part {
    static constexpr number takes[] = {
        {"set", 0, 31, 0, "descriptor set of the bindings; those of filters have the sets after it"},
        {"first_binding", 0, 1023, 0, "binding of the block of parameters; the others follow"},
        {"first_constant", 0, 1023, 0,
         "constant_id of the first number; the others follow, those of a filter's pass 32 after the pass "
         "before"},
    };
    static constexpr const glsl_file* files[] = {&functions_glsl};
    static constexpr part description{
        .kind = role::stage,
        .name = "functions",
        .summary =
            "no main: float crease_visibility(ivec2 pixel) and what it needs, for a shader of the host",
        .source = "",
        .files = files,
        .numbers = takes,
        .offers = traits<hosted_functions>::list,
    };
};

/// Stage: functions for the host's own shader, which states `#version` and places them by these numbers. The
/// last pass has `float crease_visibility(ivec2 pixel)`; one before it `uvec4 crease_handed_on(ivec2 pixel)`,
/// which the host stores to the image that the next reads. `with_prefix` gives the names another prefix, so
/// that a shader holds several passes or effects.
template <int Set = 0, int FirstBinding = 0, int FirstConstant = 0>
struct functions : functions_part {
    static constexpr int numbers[] = {Set, FirstBinding, FirstConstant};
};

}
