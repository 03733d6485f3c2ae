// SPDX-License-Identifier: MIT
#pragma once

#include <crease/spirv/validate.hpp>

#include <spirv-tools/optimizer.hpp>

#include <span>

namespace crease::spirv {

/// What a module is optimised for.
enum class goal : unsigned char { speed, size };

/// The module after SPIRV-Tools' standard optimisations. Specialization constants and bindings all survive,
/// so what an effect declares of its passes stays true of it.
/// @throws error  where the module is not valid
inline words optimise(std::span<const std::uint32_t> module, goal aim) {
    spvtools::Optimizer optimizer(SPV_ENV_VULKAN_1_1);
    std::string messages;
    optimizer.SetMessageConsumer(detail::lines_in(messages));
    if (aim == goal::speed)
        optimizer.RegisterPerformancePasses();
    else
        optimizer.RegisterSizePasses();
    spvtools::OptimizerOptions options;
    options.set_preserve_bindings(true);
    options.set_preserve_spec_constants(true);
    words optimised;
    if (!optimizer.Run(module.data(), module.size(), &optimised, options))
        throw error("the module cannot be optimised:" + messages);
    return optimised;
}

}
