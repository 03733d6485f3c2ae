// SPDX-License-Identifier: MIT
// What a program has and nothing in it uses.
#pragma once

#include <crease/spirv.hpp>

#include <cctype>
#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// The identifiers that begin with `crease_` and stand only once in a program: what is declared must be used. Comments
/// do not count, nor do the names of blocks, which only a host uses.
inline std::vector<std::string> identifiers_without_use(std::string_view text) {
    std::map<std::string, int, std::less<>> counts;
    std::string before; // the identifier before
    for (std::size_t i = 0; i < text.size();) {
        if (text.substr(i).starts_with("//")) {
            i = text.find('\n', i);
            continue;
        }
        std::size_t end = i;
        while (end < text.size() && (std::isalnum(static_cast<unsigned char>(text[end])) || text[end] == '_'))
            ++end;
        if (end == i) {
            ++i;
            continue;
        }
        const std::string word(text.substr(i, end - i));
        if (word.starts_with("crease_"))
            counts[word] += before == "uniform" && word == "crease_parameters" ? 2 : before == "buffer" ? 2 : 1;
        before = word;
        i = end;
    }
    std::vector<std::string> once;
    for (const auto& [name, count] : counts)
        if (count == 1)
            once.push_back(name);
    return once;
}

/// The functions of a module that are no entry point and that no function calls.
inline std::vector<std::string> functions_without_caller(std::span<const std::uint32_t> module) {
    constexpr unsigned name = 5, entry_point = 15, function = 54, call = 57; // opcodes
    std::set<std::uint32_t> defined, called;
    std::map<std::uint32_t, std::string> names;
    for (std::size_t at = 5; at < module.size(); at += module[at] >> 16) {
        const unsigned code = module[at] & 0xffff;
        if (code == name)
            names[module[at + 1]] = reinterpret_cast<const char*>(&module[at + 2]);
        else if (code == entry_point)
            called.insert(module[at + 2]);
        else if (code == function)
            defined.insert(module[at + 2]);
        else if (code == call)
            called.insert(module[at + 3]);
    }
    std::vector<std::string> uncalled;
    for (std::uint32_t each : defined)
        if (!called.contains(each))
            uncalled.push_back(names[each]);
    return uncalled;
}
