// SPDX-License-Identifier: MIT
#pragma once

#include <crease/compose/part.hpp>

namespace crease {

inline constexpr glsl_file work_efficient_scan_glsl{
    "scan/work_efficient_scan.glsl",
#include <crease/scan/work_efficient_scan.glsl>
};

/// Scan: the work-efficient one, which any device can do.
struct work_efficient_scan {
    static constexpr const glsl_file* files[] = {&work_efficient_scan_glsl};
    static constexpr part description{
        .kind = role::scan,
        .name = "work_efficient_scan",
        .summary = "up-sweep and down-sweep through shared memory",
        .source = "statistical-volumetric-obscurance 2015, 3.4 and A.1",
        .files = files,
    };
};

}
