// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/stage/stages.hpp>

namespace crease {

/// Dialect: GLSL 450 of whose SPIR-V naga makes WGSL. Images have no samplers, as all are read texel by
/// texel; numbers are plain constants; what compute shaders store has a format that every device can store.
struct webgpu_glsl {
    static constexpr part description{
        .kind = role::dialect,
        .name = "webgpu",
        .summary = "GLSL 450 of whose SPIR-V naga makes WGSL",
        .source = "",
        .offers = traits<webgpu_words>::list,
    };
};

}
