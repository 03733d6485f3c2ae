// SPDX-License-Identifier: MIT
#pragma once

#include <crease/spirv/validate.hpp>

#include <span>

namespace crease::spirv {

/// The module as SPIR-V assembly, with the names that it holds.
/// @throws error  where it is not SPIR-V
inline std::string disassemble(std::span<const std::uint32_t> module) {
    spvtools::SpirvTools tools(SPV_ENV_VULKAN_1_3);
    std::string messages, text;
    tools.SetMessageConsumer(detail::lines_in(messages));
    if (!tools.Disassemble(module.data(), module.size(), &text))
        throw error("the module cannot be disassembled:" + messages);
    return text;
}

}
