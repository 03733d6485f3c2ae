// SPDX-License-Identifier: MIT
#pragma once

#include <crease/compose/part.hpp>

namespace crease {

inline constexpr glsl_file compute_glsl{
    "stage/compute.glsl",
#include <crease/stage/compute.glsl>
};

struct compute_part {
    static constexpr number takes[] = {
        {"width", 1, 1024, 16, "of the workgroup, invocations"},
        {"height", 1, 1024, 16, "of the workgroup, invocations"},
    };
    static constexpr const glsl_file* files[] = {&compute_glsl};
    static constexpr part description{
        .kind = role::stage,
        .name = "compute",
        .summary = "compute shaders",
        .source = "",
        .files = files,
        .numbers = takes,
    };
};

/// Stage: compute shaders with workgroups of `Width` x `Height`. The default.
template <int Width = 16, int Height = 16>
struct compute : compute_part {
    static constexpr int numbers[] = {Width, Height};
};

}
