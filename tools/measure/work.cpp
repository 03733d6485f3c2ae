// SPDX-License-Identifier: MIT
#include "measure/work.hpp"

#include <spirv-tools/optimizer.hpp>
#include <spirv/unified1/spirv.hpp>

namespace crease::tools {

namespace {

// A module is five words of header, and then instructions that begin with their length and opcode.
template <class Words, class Visit>
void for_each_instruction(Words& module, Visit visit) {
    for (std::size_t at = 5; at < module.size(); at += module[at] >> 16)
        visit(static_cast<spv::Op>(module[at] & 0xffff), &module[at]);
}

/// Asks for every loop to be unrolled, as the optimiser only unrolls where the shader says so.
void mark_loops(spirv::words& module) {
    for_each_instruction(module, [](spv::Op op, std::uint32_t* words) {
        if (op == spv::OpLoopMerge)
            words[3] = spv::LoopControlUnrollMask;
    });
}

spirv::words unrolled(spirv::words module) {
    mark_loops(module);
    spvtools::Optimizer optimiser(SPV_ENV_VULKAN_1_1);
    optimiser.RegisterPass(spvtools::CreateFreezeSpecConstantValuePass())
        .RegisterPass(spvtools::CreateFoldSpecConstantOpAndCompositePass())
        .RegisterPerformancePasses()
        .RegisterPass(spvtools::CreateLoopUnrollPass(true))
        .RegisterPerformancePasses()
        .RegisterPass(
            spvtools::CreateLoopUnrollPass(true)) // the outer loops, once the inner ones are straight
        .RegisterPerformancePasses();
    spirv::words result;
    if (!optimiser.Run(module.data(), module.size(), &result))
        throw spirv::error("the optimiser refuses the module whose work is to be counted");
    return result;
}

bool is_fetch(spv::Op op) {
    return (op >= spv::OpImageSampleImplicitLod && op <= spv::OpImageRead) || op == spv::OpImageSparseFetch;
}

bool is_work(spv::Op op) {
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
    shader_work work;
    bool inside = false;
    for_each_instruction(straight, [&](spv::Op op, const std::uint32_t*) {
        if (op == spv::OpFunction) {
            inside = true;
            return;
        }
        if (!inside)
            return;
        work.instructions += is_work(op);
        work.fetches += is_fetch(op);
        work.counted_whole &= op != spv::OpLoopMerge;
    });
    return work;
}

}
