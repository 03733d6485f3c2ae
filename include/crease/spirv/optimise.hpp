// SPDX-License-Identifier: MIT
#pragma once

#include <crease/spirv/validate.hpp>

#include <spirv-tools/optimizer.hpp>
#include <spirv/unified1/spirv.hpp>

#include <map>
#include <span>

namespace crease::spirv {

/// What a module is optimised for.
enum class goal : unsigned char {
    speed, ///< all functions in one, as much as is known beforehand worked out
    size   ///< that too, or with functions that are called from several places left as they are: what is
           ///< smaller
};

}

namespace crease::spirv::detail {

/// Calls `use` with the words of each instruction, of which the first holds the opcode, as far as the module
/// is whole.
template <class Use>
void for_each_instruction(std::span<std::uint32_t> module, Use use) {
    constexpr std::size_t header = 5;
    for (std::size_t at = header, count = 0; at < module.size(); at += count) {
        count = module[at] >> 16;
        if (count == 0 || count > module.size() - at)
            return;
        use(static_cast<spv::Op>(module[at] & 0xffff), module.subspan(at, count));
    }
}

/// Marks the functions that are called from several places, so that the optimiser copies them to none.
inline void keep_shared_functions(std::span<std::uint32_t> module) {
    std::map<std::uint32_t, int> calls;
    for_each_instruction(module, [&](spv::Op code, std::span<std::uint32_t> instruction) {
        if (code == spv::OpFunctionCall && instruction.size() > 3)
            ++calls[instruction[3]];
    });
    for_each_instruction(module, [&](spv::Op code, std::span<std::uint32_t> instruction) {
        if (code == spv::OpFunction && instruction.size() > 3 && calls[instruction[2]] > 1)
            instruction[3] |= spv::FunctionControlDontInlineMask;
    });
}

/// Takes the marks away again: a driver decides for itself.
inline void let_drivers_inline(std::span<std::uint32_t> module) {
    for_each_instruction(module, [](spv::Op code, std::span<std::uint32_t> instruction) {
        if (code == spv::OpFunction)
            instruction[3] &= ~static_cast<std::uint32_t>(spv::FunctionControlDontInlineMask);
    });
}

/// Runs what is registered. Constants and bindings that nothing uses stay.
/// @throws error  where the module is not valid; `done` ends its sentence, as in "optimised"
inline words run(spvtools::Optimizer& optimizer, std::span<const std::uint32_t> module, const char* done) {
    std::string messages;
    optimizer.SetMessageConsumer(lines_in(messages));
    spvtools::OptimizerOptions options;
    options.set_preserve_bindings(true);
    options.set_preserve_spec_constants(true);
    words changed;
    if (!optimizer.Run(module.data(), module.size(), &changed, options))
        throw error(std::string("the module cannot be ") + done + ":" + messages);
    return changed;
}

/// Runs SPIRV-Tools' passes for a goal.
/// @throws error  where the module is not valid
inline words run_passes(std::span<const std::uint32_t> module, goal aim, vulkan_version version) {
    spvtools::Optimizer optimizer(environment_of(version)); // runs once only
    if (aim == goal::speed)
        optimizer.RegisterPerformancePasses();
    else
        optimizer.RegisterSizePasses();
    return run(optimizer, module, "optimised");
}

}

namespace crease::spirv {

/// The module after SPIRV-Tools' standard optimisations for the goal. Specialization constants and bindings
/// all survive, so what an effect declares of its passes stays true of it.
/// @param version  that the module was made for
/// @throws error  where the module is not valid
inline words optimise(std::span<const std::uint32_t> module, goal aim,
                      vulkan_version version = vulkan_version::v1_1) {
    words whole = detail::run_passes(module, aim, version);
    if (aim == goal::speed)
        return whole;
    words marked(module.begin(), module.end());
    detail::keep_shared_functions(marked);
    words shared = detail::run_passes(marked, aim, version);
    detail::let_drivers_inline(shared);
    return shared.size() < whole.size() ? shared : whole;
}

/// The module without the names and lines that debuggers show; what it does is the same.
/// @param version  that the module was made for
/// @throws error  where the module is not valid
inline words strip(std::span<const std::uint32_t> module, vulkan_version version = vulkan_version::v1_1) {
    spvtools::Optimizer optimizer(detail::environment_of(version));
    optimizer.RegisterPass(spvtools::CreateStripDebugInfoPass());
    return detail::run(optimizer, module, "stripped");
}

}
