// SPDX-License-Identifier: MIT
// What a program has and nothing in it uses.
#pragma once

#include <crease/crease.hpp>

#include <map>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Calls `action` with each word of a text and with that before it, comments aside.
template <class Action>
void for_each_word(std::string_view text, Action action) {
    std::string_view before;
    for (std::size_t i = 0; i < text.size();) {
        if (text.substr(i).starts_with("//"))
            i = text.find('\n', i);
        std::size_t end = i;
        while (end < text.size() && crease::reading::is_word(text[end]))
            ++end;
        const std::string_view word = text.substr(i, end - i);
        if (!word.empty())
            action(word, before);
        before = word.empty() ? before : word;
        i = end == i ? i + 1 : end;
    }
}

/// The same of each identifier that begins with `crease_`.
template <class Action>
void for_each_identifier(std::string_view text, Action action) {
    for_each_word(text, [&action](std::string_view word, std::string_view before) {
        if (word.starts_with("crease_"))
            action(word, before);
    });
}

/// Whether a definition is a function: a bracket is the first that tells what it is.
inline bool is_function(std::string_view text) {
    while (true) {
        const std::size_t comment = text.find("//"), mark = text.find_first_of("({=[;");
        if (mark == std::string_view::npos)
            return false;
        if (comment == std::string_view::npos || mark < comment)
            return text[mark] == '(';
        text.remove_prefix(text.find('\n', comment));
    }
}

/// The name that a piece defines; 0 where it is no definition.
inline crease::symbol defined_name(const crease::piece& p) {
    const auto table = std::make_unique<crease::symbol_table>(crease::read_symbols({p.name, p.text}));
    return table->definitions.size() == 1 ? table->definitions[0].name : 0;
}

/// The identifiers that begin with `crease_` and stand only once in a program: what is declared must be used.
/// The names of blocks do not count, which only a host uses.
inline std::vector<std::string> identifiers_without_use(std::string_view text) {
    std::map<std::string, int, std::less<>> counts;
    for_each_identifier(text, [&counts](std::string_view word, std::string_view before) {
        const bool names_block = before == "buffer" || (before == "uniform" && word == "crease_parameters");
        counts[std::string(word)] += names_block ? 2 : 1;
    });
    std::vector<std::string> once;
    for (const auto& [name, count] : counts)
        if (count == 1)
            once.push_back(name);
    return once;
}

/// The definitions of a program that nothing in it calls or names, directly or by others, from `main`, the
/// interface and what a host writes around it. The module does not tell, as glslang drops what is not called.
/// @param whole  each piece one definition, or what is not crease's, or a piece of the root
inline std::vector<std::string> definitions_without_caller(std::span<const crease::piece> whole) {
    std::map<crease::symbol, std::set<crease::symbol>> references;
    std::map<crease::symbol, std::string> texts;
    std::set<crease::symbol> reached;
    std::vector<crease::symbol> next;
    for (const crease::piece& each : whole) {
        const crease::symbol name = defined_name(each);
        const bool is_root =
            each.name == "interface" || each.name == "host" || name == crease::main_symbol || name == 0;
        for_each_identifier(each.text, [&](std::string_view word, std::string_view) {
            if (is_root)
                next.push_back(crease::symbol_of(word));
            else
                references[name].insert(crease::symbol_of(word));
        });
        if (!is_root && name != 0)
            texts[name] = each.text;
    }
    while (!next.empty()) {
        const crease::symbol name = next.back();
        next.pop_back();
        if (reached.insert(name).second)
            next.insert(next.end(), references[name].begin(), references[name].end());
    }
    std::vector<std::string> uncalled;
    for (const auto& [name, text] : texts)
        if (!reached.contains(name))
            uncalled.push_back(text);
    return uncalled;
}
