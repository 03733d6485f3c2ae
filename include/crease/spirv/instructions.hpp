// SPDX-License-Identifier: MIT
#pragma once

#include <crease/spirv/validate.hpp>

#include <spirv/unified1/spirv.hpp>

#include <bit>
#include <cstring>
#include <map>
#include <optional>
#include <span>
#include <vector>

namespace crease::spirv::detail {

/// One instruction: its opcode, its result and its words, of which word 0 holds the opcode.
struct instruction {
    spv::Op code = spv::OpNop;
    std::uint32_t result = 0, type = 0; ///< ids; 0: none
    words operands;                     ///< all words of the instruction

    std::uint32_t operator[](std::size_t word) const { return operands.at(word); }

    /// The literal string that begins at a word.
    std::string text(std::size_t word) const {
        std::string characters;
        for (std::size_t i = word; i < operands.size(); ++i)
            for (unsigned shift = 0; shift < 32; shift += 8) {
                const char c = static_cast<char>(operands[i] >> shift & 0xff);
                if (c == '\0')
                    return characters;
                characters += c;
            }
        return characters;
    }
};

/// What a decoration's key says: the id, its member or -1 for the id itself, and the decoration.
struct decoration_key {
    std::uint32_t id = 0;
    int member = -1;
    spv::Decoration decoration = spv::DecorationMax;
    auto operator<=>(const decoration_key&) const = default;
};

/// A module's instructions outside functions, by what reflection asks for.
struct instructions {
    std::vector<instruction> all;                   ///< in order
    std::map<std::uint32_t, instruction> by_result; ///< types, constants and variables
    std::map<std::uint32_t, std::string> names;     ///< OpName
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::string> member_names;
    std::map<decoration_key, std::uint32_t> decorations; ///< the first literal, or 0

    const instruction& of(std::uint32_t id) const { return by_result.at(id); }
    std::string name_of(std::uint32_t id) const {
        const auto found = names.find(id);
        return found == names.end() ? std::string() : found->second;
    }
    std::optional<std::uint32_t> decoration(std::uint32_t id, spv::Decoration which, int member = -1) const {
        const auto found = decorations.find({id, member, which});
        return found == decorations.end() ? std::nullopt : std::optional(found->second);
    }

    void add(const instruction& each) {
        all.push_back(each);
        if (each.result)
            by_result[each.result] = each;
        const auto literal = [&each](std::size_t word) {
            return each.operands.size() > word ? each[word] : 0;
        };
        if (each.code == spv::OpName)
            names.emplace(each[1],
                          each.text(2)); // one that a constant equals has its number, and a later name
        else if (each.code == spv::OpMemberName)
            member_names[{each[1], each[2]}] = each.text(3);
        else if (each.code == spv::OpDecorate)
            decorations[{each[1], -1, static_cast<spv::Decoration>(each[2])}] = literal(3);
        else if (each.code == spv::OpMemberDecorate)
            decorations[{each[1], static_cast<int>(each[2]), static_cast<spv::Decoration>(each[3])}] =
                literal(4);
    }
};

/// Reads a module up to its first function.
/// @throws error  where it is not SPIR-V
inline instructions read(std::span<const std::uint32_t> module) {
    spvtools::Context context(SPV_ENV_VULKAN_1_3);
    std::string messages;
    context.SetMessageConsumer(lines_in(messages));
    instructions found;
    const auto add = [](void* user, const spv_parsed_instruction_t* parsed) {
        const auto code = static_cast<spv::Op>(parsed->opcode);
        auto& into = *static_cast<instructions*>(user);
        const bool in_function = !into.all.empty() && into.all.back().code == spv::OpFunction;
        if (!in_function)
            into.add({code,
                      parsed->result_id,
                      parsed->type_id,
                      {parsed->words, parsed->words + parsed->num_words}});
        return SPV_SUCCESS;
    };
    if (spvBinaryParse(context.CContext(), &found, module.data(), module.size(), nullptr, add, nullptr) !=
        SPV_SUCCESS)
        throw error("the module cannot be read:" + messages);
    return found;
}

}
