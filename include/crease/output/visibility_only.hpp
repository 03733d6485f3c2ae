// SPDX-License-Identifier: MIT
#pragma once

#include <crease/encoding.hpp>
#include <crease/output/occlusion_alone.hpp>

namespace crease {

inline constexpr glsl_file visibility_result_glsl{
    "output/visibility_result.glsl",
#include <crease/output/visibility_result.glsl>
};

inline constexpr glsl_file visibility_only_glsl{
    "output/visibility_only.glsl",
#include <crease/output/visibility_only.glsl>
};

/// Output: visibility in [0, 1], 1 where open. The default.
struct visibility_only {
    static constexpr const glsl_file* gathered[] = {&occlusion_alone_glsl};
    static constexpr const encoding* images[] = {&visibility_encoding};
    static constexpr part description{
        .kind = role::output,
        .name = "visibility_only",
        .summary = "visibility, 1 open and 0 closed",
        .source = "stochastic-depth-ao 2020, 2.2",
        .glsl = &visibility_only_glsl,
        .helpers = gathered,
        .offers = traits<any_order>::list,
        .result = &visibility_result_glsl,
        .between = &visibility_depth_encoding,
        .final_images = images,
    };
};

}
