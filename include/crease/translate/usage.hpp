// SPDX-License-Identifier: MIT
#pragma once

#include <crease/spirv/instructions.hpp>

#include <algorithm>
#include <initializer_list>
#include <set>
#include <span>

namespace crease::translate::detail {

/// What a module does that not every language can.
struct usage {
    std::set<unsigned> operations;   ///< opcodes
    std::set<unsigned> capabilities; ///< that it declares
    std::set<unsigned> functions;    ///< of GLSL.std.450
    std::set<unsigned> builtins;     ///< inputs and outputs that it declares

    bool is_any_of(std::initializer_list<unsigned> wanted) const {
        return std::ranges::any_of(wanted, [this](unsigned each) { return operations.contains(each); });
    }
    bool calls_any_of(std::initializer_list<unsigned> wanted) const {
        return std::ranges::any_of(wanted, [this](unsigned each) { return functions.contains(each); });
    }
};

/// @param module  valid SPIR-V
inline usage usage_of(std::span<const std::uint32_t> module) {
    constexpr std::size_t header_words = 5;
    const spirv::detail::instructions outside = spirv::detail::read(module);
    usage found;
    for (const auto& [key, literal] : outside.decorations)
        if (key.decoration == spv::DecorationBuiltIn)
            found.builtins.insert(literal);
    for (std::size_t at = header_words; at < module.size(); at += module[at] >> 16) {
        const unsigned code = module[at] & 0xffff;
        found.operations.insert(code);
        if (code == spv::OpCapability)
            found.capabilities.insert(module[at + 1]);
        else if (code == spv::OpExtInst)
            found.functions.insert(module[at + 4]);
    }
    return found;
}

}
