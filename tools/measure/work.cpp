// SPDX-License-Identifier: MIT
#include "measure/work.hpp"

#include "measure/loops.hpp"

#include <spirv-tools/optimizer.hpp>
#include <spirv/unified1/spirv.hpp>

#include <algorithm>

namespace crease::tools {

namespace {

constexpr std::size_t most_unrolled =
    1 << 17; // words of a loop written out, beyond which optimising takes long

/// Asks the optimiser to unroll the innermost loops that are not too long, and no others.
/// @return whether there are any
bool mark_loops(spirv::words& module) {
    const std::vector<module_loop> loops = find_loops(module);
    bool any = false;
    for (std::size_t i = 0; i < loops.size(); ++i) {
        const module_loop& own = loops[i];
        const bool innermost = i + 1 == loops.size() || !own.contains(loops[i + 1].first);
        const bool unrolls =
            innermost && own.turns > 0 && own.turns * (own.last - own.first) <= most_unrolled;
        module[own.merge + 3] = unrolls ? spv::LoopControlUnrollMask : spv::LoopControlMaskNone;
        any |= unrolls;
    }
    return any;
}

spirv::words optimised(const spirv::words& module, spvtools::Optimizer& optimiser) {
    optimiser.RegisterPerformancePasses();
    spirv::words result;
    if (!optimiser.Run(module.data(), module.size(), &result))
        throw spirv::error("the module whose work is to be counted cannot be optimised");
    return result;
}

/// The module with its constants in place and its short loops written out, the inner ones first.
spirv::words unrolled(const spirv::words& module) {
    spvtools::Optimizer constants(SPV_ENV_VULKAN_1_1);
    constants.RegisterPass(spvtools::CreateFreezeSpecConstantValuePass())
        .RegisterPass(spvtools::CreateFoldSpecConstantOpAndCompositePass());
    spirv::words result = optimised(module, constants);
    constexpr int deepest = 4; // loops in loops
    for (int level = 0; level < deepest && mark_loops(result); ++level) {
        spvtools::Optimizer loops(SPV_ENV_VULKAN_1_1);
        loops.RegisterPass(spvtools::CreateLoopUnrollPass(true));
        result = optimised(result, loops);
    }
    return result;
}

bool is_fetch(unsigned op) {
    return (op >= spv::OpImageSampleImplicitLod && op <= spv::OpImageRead) || op == spv::OpImageSparseFetch;
}

bool is_work(unsigned op) {
    switch (op) {
    case spv::OpLabel:
    case spv::OpBranch:
    case spv::OpBranchConditional:
    case spv::OpSelectionMerge:
    case spv::OpLoopMerge:
    case spv::OpReturn:
    case spv::OpFunctionEnd:
    case spv::OpFunctionParameter:
    case spv::OpVariable:
    case spv::OpPhi:
        return false;
    default:
        return true;
    }
}

}

shader_work count_work(const spirv::words& module) {
    const spirv::words straight = unrolled(module);
    const std::vector<module_loop> loops = find_loops(straight);
    shader_work work;
    bool inside = false;
    for_each_instruction(straight, [&](unsigned op, std::size_t at) {
        inside |= op == spv::OpFunction;
        if (!inside || op == spv::OpFunction)
            return;
        unsigned times = 1;
        for (const module_loop& each : loops)
            if (each.contains(at) && each.turns > 0)
                times *= each.turns;
        work.instructions += times * is_work(op);
        work.fetches += times * is_fetch(op);
    });
    work.counted_whole = std::ranges::all_of(loops, [](const module_loop& each) { return each.turns > 0; });
    return work;
}

}
