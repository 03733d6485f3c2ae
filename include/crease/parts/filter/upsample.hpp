// SPDX-License-Identifier: MIT
#pragma once

#include <crease/compose/core_files.hpp>
#include <crease/parts/filter/planes.hpp>

namespace crease {

inline constexpr glsl_file upsample_glsl{
    "filter/upsample.glsl",
#include <crease/filter/upsample.glsl>
};

struct upsample_part {
    using needs = traits<handed_on_normals, any_resolution>;
    static constexpr number takes[] = {{"factor", 2, 8, 2, "how much smaller the sides of the input are"}};
    static constexpr setting reads[] = {plane_reach_setting};
    static constexpr const glsl_file* files[] = {&encoding_normal_glsl, &plane_glsl};
    // It reads near its pixel, so columns of workgroups would not pay.
    static constexpr const glsl_file* upsampling[] = {&upsample_glsl, &pixel_glsl};
    static constexpr step passes[] = {
        {.name = "upsample", .files = upsampling, .upsampling = 0},
    };
    static constexpr part description{
        .kind = role::filter,
        .name = "upsample",
        .summary = "runs what stands before it at a lower resolution, and upsamples along tangent planes",
        .source =
            "Kopf et al. 2007, Joint Bilateral Upsampling; statistical-volumetric-obscurance 2015, 4.6.1",
        .files = files,
        .numbers = takes,
        .settings = reads,
        .steps = passes,
        .needs = needs::list,
    };
};

/// Filter: what stands before it runs at 1 / `Factor` of the resolution each way. A pixel takes the four
/// nearest of the smaller picture, by their distance and by its own from their tangent planes, as
/// `plane_filter` does: so it reads the depth of the picture, and no normal.
template <int Factor = 2>
struct upsample : upsample_part {
    static constexpr int numbers[] = {Factor};
};

}
