// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/dialect/dialects.hpp>

namespace crease {

/// Dialect: GLSL 450 of which naga makes WGSL, by itself or of its SPIR-V. Images have no samplers, as all
/// are read texel by texel; numbers are plain constants; what compute shaders store has a format that every
/// device can store.
struct webgpu_glsl {
    static constexpr const glsl_file* files[] = {&view_set_in_main_glsl};
    static constexpr part description{
        .kind = role::dialect,
        .name = "webgpu",
        .summary = "GLSL 450 of which naga makes WGSL",
        .source = "",
        .files = files,
        .offers = traits<webgpu_words>::list,
    };
};

}
