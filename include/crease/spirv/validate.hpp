// SPDX-License-Identifier: MIT
#pragma once

#include <crease/spirv/module.hpp>
#include <crease/spirv/vulkan_version.hpp>

#include <spirv-tools/libspirv.hpp>

#include <span>
#include <string>
#include <string_view>

namespace crease::spirv::detail {

constexpr spv_target_env environment_of(vulkan_version version) {
    switch (version) {
    case vulkan_version::v1_0:
        return SPV_ENV_VULKAN_1_0;
    case vulkan_version::v1_1:
        return SPV_ENV_VULKAN_1_1;
    case vulkan_version::v1_2:
        return SPV_ENV_VULKAN_1_2;
    default:
        return SPV_ENV_VULKAN_1_3;
    }
}

/// Adds each message of SPIRV-Tools to `text` as a line of its own.
inline spvtools::MessageConsumer lines_in(std::string& text) {
    return [&text](spv_message_level_t, const char*, const spv_position_t& position, const char* message) {
        text += "\ninstruction " + std::to_string(position.index) + ": " + message;
    };
}

}

namespace crease::spirv {

/// Checks a module against the rules of SPIR-V and of Vulkan.
/// @param what    names the module in the error
/// @throws error  with the validator's messages
inline void validate(std::span<const std::uint32_t> module, vulkan_version version = vulkan_version::v1_1,
                     std::string_view what = "the module") {
    spvtools::SpirvTools tools(detail::environment_of(version));
    std::string messages;
    tools.SetMessageConsumer(detail::lines_in(messages));
    if (!tools.Validate(module.data(), module.size()))
        throw error(std::string(what) + " is not valid SPIR-V for Vulkan " + std::string(name_of(version)) +
                    ":" + messages);
}

}
