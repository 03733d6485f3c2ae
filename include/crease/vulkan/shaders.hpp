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

/// Compiles the passes of an effect, in their order.
/// @throws spirv::error  where one does not compile
inline std::vector<pass_shaders> compile(const effect_view& effect) {
    std::vector<pass_shaders> all;
    for (const pass& each : effect.passes) {
        const bool drawn = each.stage == stage_kind::fragment;
        all.push_back({spirv::compile(each), drawn ? spirv::compile_vertex(each) : spirv::words()});
    }
    return all;
}

}
