// SPDX-License-Identifier: MIT
#pragma once

#include <crease/compose/part.hpp>

namespace crease {

inline constexpr glsl_file subgroup_scan_glsl{
    "scan/subgroup_scan.glsl",
#include <crease/scan/subgroup_scan.glsl>
};

/// Scan: by subgroup operations, where the device has them. Takes all subgroups of a workgroup to be full, as
/// lavapipe's are where the workgroup's width is a multiple of 8. No GPU has run it yet.
struct subgroup_scan {
    static constexpr const glsl_file* files[] = {&subgroup_scan_glsl};
    static constexpr part description{
        .kind = role::scan,
        .name = "subgroup_scan",
        .summary = "by subgroup operations",
        .source = "Vulkan 1.1, subgroup operations",
        .files = files,
        .extension = "GL_KHR_shader_subgroup_arithmetic",
        .features = {.subgroup_arithmetic = true},
    };
};

}
