// SPDX-License-Identifier: MIT
#pragma once

#include <crease/spirv/optimise.hpp>
#include <crease/translate/numbering.hpp>

#include <cctype>
#include <unordered_map>

namespace crease::translate::detail {

/// What SPIRV-Cross calls a specialization constant in HLSL and GLSL.
inline std::string macro_of(unsigned id) {
    return "SPIRV_CROSS_CONSTANT_ID_" + std::to_string(id);
}

/// The constants of a pass with the defaults that the host wants, and those that a host's module has beside
/// them.
inline std::vector<placed_constant> constants_of(const pass& which, const spirv::reflection& module,
                                                 const target& to) {
    std::vector<placed_constant> all;
    const bool has_macros = to.to != language::msl;
    for (const constant& c : which.constants) {
        const auto other = to.constants.find(std::string(c.part) + "." + std::string(c.number));
        std::string macro = "crease_" + std::string(c.part) + "_" + std::string(c.number);
        std::ranges::transform(macro, macro.begin(),
                               [](unsigned char letter) { return static_cast<char>(std::toupper(letter)); });
        all.push_back({std::string(c.part), std::string(c.number), c.id, has_macros ? macro : "",
                       other == to.constants.end() ? c.value : other->second});
    }
    for (const spirv::specialization_constant& found : module.constants)
        if (std::ranges::find(all, found.id, &placed_constant::id) == all.end())
            all.push_back({"", found.name, found.id, has_macros ? macro_of(found.id) : "",
                           static_cast<int>(found.value)});
    return all;
}

/// The module with these values as its constants' defaults, or as the values of what is no constant that can
/// be set any more.
/// @throws error  where it is not valid
inline spirv::words with_constants(std::span<const std::uint32_t> module,
                                   const std::vector<placed_constant>& constants, bool frozen) {
    std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> values;
    for (const placed_constant& each : constants)
        values[each.id] = {static_cast<std::uint32_t>(each.value)};
    spvtools::Optimizer optimizer(spirv::detail::environment_of(spirv::vulkan_version::v1_3));
    optimizer.RegisterPass(spvtools::CreateSetSpecConstantDefaultValuePass(values));
    if (frozen) {
        optimizer.RegisterPass(spvtools::CreateFreezeSpecConstantValuePass());
        optimizer.RegisterPass(spvtools::CreateFoldSpecConstantOpAndCompositePass());
    }
    return spirv::detail::run(optimizer, module, "given other constants");
}

/// Calls the constants in a text what the host is told.
inline void name_constants(std::string& text, const std::vector<placed_constant>& constants) {
    for (const placed_constant& each : constants) {
        const std::string old = macro_of(each.id);
        for (std::size_t at = text.find(old); at != text.npos; at = text.find(old, at + 1))
            if (!std::isdigit(static_cast<unsigned char>(text[at + old.size()]))) // as 1 begins 10
                text.replace(at, old.size(), each.macro);
    }
}

}
