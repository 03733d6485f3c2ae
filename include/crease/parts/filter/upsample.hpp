// SPDX-License-Identifier: MIT
#pragma once

#include <crease/compose/core_files.hpp>
#include <crease/compose/part.hpp>

namespace crease {

inline constexpr glsl_file upsample_glsl{
    "filter/upsample.glsl",
#include <crease/filter/upsample.glsl>
};

struct upsample_part {
    static constexpr number takes[] = {{"factor", 2, 8, 2, "how much smaller the sides of the input are"}};
    static constexpr setting reads[] = {
        {"sharpness", 32, 0, 1000,
         "how fast a weight falls with the distance from the tangent plane, per radius"},
    };
    // It reads near its pixel, so columns of workgroups would not pay.
    static constexpr const glsl_file* files[] = {&upsample_glsl, &pixel_glsl};
    static constexpr step passes[] = {
        {.name = "upsample", .files = files, .upsampling = 0},
    };
    static constexpr part description{
        .kind = role::filter,
        .name = "upsample",
        .summary = "runs what stands before it at a lower resolution, and upsamples along tangent planes",
        .source = "statistical-volumetric-obscurance 2015, 4.6.1; stochastic-depth-ao 2020, 9.1",
        .numbers = takes,
        .settings = reads,
        .steps = passes,
    };
};

/// Filter: what stands before it runs at 1 / `Factor` of the resolution each way.
template <int Factor = 2>
struct upsample : upsample_part {
    static constexpr int numbers[] = {Factor};
};

}
