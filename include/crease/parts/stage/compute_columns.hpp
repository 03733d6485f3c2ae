// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/stage/compute.hpp>

namespace crease {

inline constexpr glsl_file compute_columns_glsl{
    "stage/compute_columns.glsl",
#include <crease/stage/compute_columns.glsl>
};

struct compute_columns_part {
    static constexpr number takes[] = {
        {"width", 1, 1024, 16, "of the workgroup, invocations"},
        {"height", 1, 1024, 16, "of the workgroup, invocations"},
        {"across", 1, 1024, 16, "workgroups side by side that run down the picture together"},
    };
    static constexpr const glsl_file* files[] = {&compute_glsl, &compute_columns_glsl};
    static constexpr part description{
        .kind = role::stage,
        .name = "compute_columns",
        .summary = "compute shaders whose workgroups run in columns, for processors and their caches",
        .source = "",
        .files = files,
        .numbers = takes,
    };
};

/// Stage: compute shaders with workgroups of `Width` x `Height`, of which `Across` side by side run down the
/// picture together, so that they find in a processor's cache what they share.
template <int Width = 16, int Height = 16, int Across = 16>
struct compute_columns : compute_columns_part {
    static constexpr int numbers[] = {Width, Height, Across};
};

}
