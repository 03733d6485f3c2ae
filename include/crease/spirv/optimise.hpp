// SPDX-License-Identifier: MIT
#pragma once

#include <crease/spirv/validate.hpp>

#include <spirv-tools/optimizer.hpp>

#include <span>

namespace crease::spirv {

/// What a module is optimised for.
enum class goal : unsigned char { speed, size };

}

namespace crease::spirv::detail {

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

}

namespace crease::spirv {

/// The module after SPIRV-Tools' standard optimisations. Specialization constants and bindings all survive,
/// so what an effect declares of its passes stays true of it.
/// @param version  that the module was made for
/// @throws error  where the module is not valid
inline words optimise(std::span<const std::uint32_t> module, goal aim,
                      vulkan_version version = vulkan_version::v1_1) {
    spvtools::Optimizer optimizer(detail::environment_of(version));
    if (aim == goal::speed)
        optimizer.RegisterPerformancePasses();
    else
        optimizer.RegisterSizePasses();
    return detail::run(optimizer, module, "optimised");
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
