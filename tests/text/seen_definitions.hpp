// SPDX-License-Identifier: MIT
// Which programs hold a definition that no program before them did.
#pragma once

#include "text/unused.hpp"

#include <crease/crease.hpp>

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// The pieces of a program, of which those that are one definition together are joined.
class joined_pieces {
public:
    explicit joined_pieces(std::span<const crease::piece> whole) {
        texts_.reserve(whole.size());
        bool is_open = false;
        for (const crease::piece& each : whole) {
            if (!is_open) {
                texts_.emplace_back();
                pieces_.push_back({each.name, ""});
            }
            std::string& text = texts_.back();
            text += each.text;
            is_open = std::ranges::count(text, '{') > std::ranges::count(text, '}');
            pieces_.back().text = text;
        }
    }
    joined_pieces(const joined_pieces&) = delete;

    auto begin() const { return pieces_.begin(); }
    auto end() const { return pieces_.end(); }

private:
    std::vector<std::string> texts_;
    std::vector<crease::piece> pieces_;
};

/// The definitions of all programs so far, each with what it depends on: heads of functions, structs and
/// lines of the interface. A compiler knows no more of a definition: where all of a program's stood in
/// programs that compile, and it declares each name before it uses it, it compiles too.
class seen_definitions {
public:
    /// Adds the definitions of a program.
    /// @param language  and stage, which decide with the extensions what a definition may do
    /// @returns whether one of them is new
    bool add(std::string language, const joined_pieces& program) {
        declarations declared;
        for (const crease::piece& each : program)
            declare(each, declared);
        for (auto [at, end] = declared.equal_range("extension"); at != end; ++at)
            language += at->second->text;
        const fragment& where = read(language);
        bool is_new = false;
        for (const crease::piece& each : program)
            if (each.name != "interface")
                is_new |= known_.insert(with_dependencies(where, read(each.text), declared)).second;
        return is_new;
    }

private:
    /// A definition, the head of a function or a line of an interface, read once.
    struct fragment {
        std::string_view text;
        std::vector<std::string_view> words;
        std::string_view defines;
        std::string_view member; ///< of a block or struct: the last name of a line
    };
    using declarations = std::multimap<std::string_view, const fragment*>;

    std::map<std::string, fragment, std::less<>> fragments_;
    std::set<std::vector<const fragment*>> known_;

    const fragment& read(std::string_view text) {
        const auto [at, is_new] = fragments_.try_emplace(std::string(text));
        fragment& own = at->second;
        if (is_new) {
            own.text = at->first;
            const crease::symbol name = defined_name({"", own.text});
            for_each_word(own.text, [&own, name](std::string_view word, std::string_view) {
                own.words.push_back(word);
                own.defines = crease::symbol_of(word) == name ? word : own.defines;
                own.member = word[0] > '9' ? word : own.member;
            });
        }
        return own;
    }

    /// Adds what a piece declares, under each name by which a definition depends on it.
    void declare(const crease::piece& each, declarations& declared) {
        if (each.name == "interface") {
            for (std::string_view rest = each.text; !rest.empty(); rest.remove_prefix(rest.find('\n') + 1)) {
                const fragment& line = read(without_numbers(rest.substr(0, rest.find('\n') + 1)));
                for (std::string_view word : line.words)
                    if (word.starts_with("crease_") || word == line.member || word == "extension")
                        declared.emplace(word, &line);
            }
        } else if (const fragment& own = read(each.text); !own.defines.empty()) {
            declared.emplace(own.defines, is_function(own.text) ? &read(head_of(own.text)) : &own);
        }
    }

    /// A line of an interface without what changes no type: the numbers of bindings and the values of
    /// constants.
    static std::string without_numbers(std::string_view line) {
        std::string kept;
        for (std::size_t i = 0; i < line.size(); ++i) {
            if (kept.ends_with("= "))
                i = line.find_first_of(",);\n", i);
            kept += line[i];
        }
        return kept;
    }

    static std::string_view head_of(std::string_view function) {
        while (function.starts_with("//") || function.starts_with("\n"))
            function.remove_prefix(function.find('\n') + 1);
        return function.substr(0, function.find('{'));
    }

    static std::vector<const fragment*> with_dependencies(const fragment& language, const fragment& own,
                                                          const declarations& declared) {
        std::vector<const fragment*> all{&own, &language};
        for (std::size_t next = 0; next < all.size(); ++next)
            for (std::string_view word : all[next]->words)
                for (auto [at, end] = declared.equal_range(word); at != end; ++at)
                    if (std::ranges::find(all, at->second) == all.end())
                        all.push_back(at->second);
        std::ranges::sort(all);
        return all;
    }
};

/// The names that a program uses before it declares them, or without.
inline std::vector<std::string> names_before_declaration(const joined_pieces& program) {
    std::vector<std::string> found;
    std::set<crease::symbol> declared;
    for (const crease::piece& each : program) {
        declared.insert(defined_name(each));
        for_each_identifier(each.text, [&](std::string_view word, std::string_view) {
            if (each.name == "interface")
                declared.insert(crease::symbol_of(word));
            else if (!declared.contains(crease::symbol_of(word)))
                found.emplace_back(word);
        });
    }
    return found;
}
