// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/stage/stages.hpp>

namespace crease {

inline constexpr glsl_file fragment_glsl{
    "stage/fragment.glsl",
#include <crease/stage/fragment.glsl>
};

inline constexpr glsl_file fullscreen_glsl{
    "stage/fullscreen.glsl",
#include <crease/stage/fullscreen.glsl>
};

/// Stage: a triangle that covers the output, and fragment shaders.
struct fragment {
    static constexpr const glsl_file* files[] = {&fragment_glsl};
    static constexpr part description{
        .kind = role::stage,
        .name = "fragment",
        .summary = "full-screen fragment shaders",
        .source = "",
        .files = files,
        .offers = traits<fragment_programs>::list,
    };
};

}
