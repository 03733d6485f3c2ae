// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/output/outputs.hpp>

namespace crease {

inline constexpr glsl_file visibility_only_glsl{
    "output/visibility_only.glsl",
#include <crease/output/visibility_only.glsl>
};

/// Output: visibility in [0, 1], 1 where open. The default.
struct visibility_only {
    static constexpr const glsl_file* files[] = {&encoding_visibility_glsl, &encoding_visibility_depth_glsl,
                                                 &visibility_only_glsl};
    static constexpr resource images[] = {between_image(format::r32_uint), visibility_image};
    static constexpr part description{
        .kind = role::output,
        .name = "visibility_only",
        .summary = "visibility, 1 open and 0 closed",
        .source = "stochastic-depth-ao 2020, 2.2",
        .files = files,
        .resources = images,
        .offers = traits<handed_on_normals, any_resolution>::list,
    };
};

}
