// SPDX-License-Identifier: MIT
#include "measure/loops.hpp"

#include <spirv/unified1/spirv.hpp>

#include <optional>
#include <unordered_map>

namespace crease::tools {

namespace {

unsigned opcode(std::uint32_t first_word) {
    return first_word & 0xffff;
}

constexpr unsigned most_turns = 1 << 20;

/// Finds labels, and the instructions that loop counters are made of, by their ids.
class definitions {
public:
    explicit definitions(const spirv::words& module) : module_(module) {
        for_each_instruction(module, [this](unsigned op, std::size_t at) {
            if (op == spv::OpLabel)
                places_[module_[at + 1]] = at;
            else if (op == spv::OpConstant || op == spv::OpPhi || is_sum(op) || is_comparison(op))
                places_[module_[at + 2]] = at;
        });
    }

    /// The word at which the instruction of an id begins; none where it is not one of these.
    std::optional<std::size_t> find(std::uint32_t id) const {
        const auto found = places_.find(id);
        return found == places_.end() ? std::nullopt : std::optional(found->second);
    }
    bool is(std::uint32_t id, unsigned op) const {
        const auto at = find(id);
        return at && (opcode(module_[*at])) == op;
    }
    std::optional<std::int64_t> whole_number(std::uint32_t id) const {
        if (!is(id, spv::OpConstant))
            return {};
        return static_cast<std::int32_t>(module_[*find(id) + 3]);
    }

    static bool is_sum(unsigned op) { return op == spv::OpIAdd || op == spv::OpISub; }
    static bool is_comparison(unsigned op) {
        return op >= spv::OpUGreaterThan && op <= spv::OpSLessThanEqual;
    }

private:
    const spirv::words& module_;
    std::unordered_map<std::uint32_t, std::size_t> places_;
};

bool holds(unsigned op, std::int64_t a, std::int64_t b) {
    switch (op) {
    case spv::OpUGreaterThan:
    case spv::OpSGreaterThan:
        return a > b;
    case spv::OpUGreaterThanEqual:
    case spv::OpSGreaterThanEqual:
        return a >= b;
    case spv::OpULessThan:
    case spv::OpSLessThan:
        return a < b;
    default:
        return a <= b;
    }
}

/// How often a loop runs that goes on while a counter compares so with a constant.
unsigned count_turns(const spirv::words& module, const definitions& by_id, std::uint32_t condition) {
    const auto comparison = by_id.find(condition);
    if (!comparison || !definitions::is_comparison(opcode(module[*comparison])))
        return 0;
    const std::uint32_t counter = module[*comparison + 3];
    const auto bound = by_id.whole_number(module[*comparison + 4]);
    if (!bound || !by_id.is(counter, spv::OpPhi))
        return 0;
    const std::size_t phi = *by_id.find(counter);
    std::optional<std::int64_t> start, stride;
    for (std::size_t i = phi + 3; i < phi + (module[phi] >> 16); i += 2) {
        const auto from = by_id.find(module[i]);
        if (const auto number = by_id.whole_number(module[i]))
            start = number;
        else if (from && definitions::is_sum(opcode(module[*from])) && module[*from + 3] == counter)
            if (const auto added = by_id.whole_number(module[*from + 4]))
                stride = opcode(module[*from]) == spv::OpISub ? -*added : *added;
    }
    if (!start || !stride)
        return 0;
    unsigned turns = 0;
    for (std::int64_t i = *start; holds(opcode(module[*comparison]), i, *bound); i += *stride)
        if (++turns == most_turns)
            return 0;
    return turns;
}

}

std::vector<module_loop> find_loops(const spirv::words& module) {
    const definitions by_id(module);
    std::vector<module_loop> loops;
    std::size_t label = 0;
    for_each_instruction(module, [&](unsigned op, std::size_t at) {
        if (op == spv::OpLabel)
            label = at;
        if (op == spv::OpLoopMerge)
            loops.push_back({.first = label, .last = *by_id.find(module[at + 1]), .merge = at});
        if (op != spv::OpBranchConditional)
            return;
        for (module_loop& each : loops) {
            const std::uint32_t after = module[each.merge + 1];
            if (each.contains(at) && (module[at + 2] == after || module[at + 3] == after) && each.turns == 0)
                each.turns = count_turns(module, by_id, module[at + 1]);
        }
    });
    return loops;
}

}
