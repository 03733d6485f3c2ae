// SPDX-License-Identifier: MIT
#pragma once

#include <crease/spirv.hpp>

namespace crease::tools {

/// A loop of an optimised module, whose blocks stand one after another.
struct module_loop {
    std::size_t first = 0, last = 0; ///< words from its header's label up to its merge block's
    std::size_t merge = 0;           ///< word of its OpLoopMerge
    unsigned turns = 0;              ///< how often its body runs; 0 where that is not a constant

    bool contains(std::size_t word) const { return word >= first && word < last; }
};

/// The loops of a module in the order of their headers, the outer before the inner ones.
std::vector<module_loop> find_loops(const spirv::words& module);

/// Calls `visit` with the opcode of each instruction and the word that it begins at.
template <class Visit>
void for_each_instruction(const spirv::words& module, Visit visit) {
    constexpr std::size_t header = 5; // words
    for (std::size_t at = header; at < module.size(); at += module[at] >> 16)
        visit(module[at] & 0xffff, at);
}

}
