// SPDX-License-Identifier: MIT
#pragma once

#include <crease/spirv/compile.hpp>

#include <vector>

namespace crease::vulkan {

/// The SPIR-V of one pass.
struct pass_shaders {
    spirv::words main;   ///< the compute or fragment shader
    spirv::words vertex; ///< of a fragment pass; empty otherwise
};

/// Compiles a compute or fragment pass.
/// @throws spirv::error  where it does not compile
inline pass_shaders compile(const pass& which) {
    const bool drawn = which.stage == stage_kind::fragment;
    return {spirv::compile(which), drawn ? spirv::compile_vertex(which) : spirv::words()};
}

/// Compiles the passes of an effect, in their order; of geometry passes, which the host's shaders make whole,
/// nothing.
/// @throws spirv::error  where one does not compile
inline std::vector<pass_shaders> compile(const effect_view& effect) {
    std::vector<pass_shaders> all;
    for (const pass& each : effect.passes)
        all.push_back(each.stage == stage_kind::geometry ? pass_shaders{} : compile(each));
    return all;
}

}
