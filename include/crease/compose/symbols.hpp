// SPDX-License-Identifier: MIT
#pragma once

#include <crease/compose/glsl_file.hpp>
#include <crease/effect/fixed_list.hpp>

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace crease {

/// An identifier of GLSL as a number (FNV-1a); a test checks that those of crease all differ.
using symbol = std::uint32_t;

inline constexpr symbol empty_symbol = 2166136261u;

/// The symbol of `text` after what `before` stands for.
constexpr symbol symbol_of(std::string_view text, symbol before = empty_symbol) {
    for (char c : text)
        before = (before ^ static_cast<unsigned char>(c)) * 16777619u;
    return before;
}

inline constexpr symbol crease_prefix = symbol_of("crease_"), main_symbol = symbol_of("main");

/// A function, struct, constant or variable at the top level of a file.
struct definition {
    symbol name = 0;                  ///< begins with `crease_`, or is `main`
    std::uint16_t begin = 0, end = 0; ///< whole lines of the text, comments before it included
    std::uint16_t line = 0;           ///< of the text, from 0
    std::uint16_t first_reference = 0, references = 0; ///< into `symbol_table::references`
};

/// What a file defines, and the identifiers that begin with `crease_` in each definition.
struct symbol_table {
    const glsl_file* file = nullptr;
    fixed_list<definition, 40> definitions;
    fixed_list<symbol, 240> references;
};

namespace reading {

/// What a character is to `read_symbols`: signs are those that definitions are known by.
enum character_kind : unsigned char { plain, word, line_end, sign };

/// The kinds of all characters. A table, as a compiler evaluates one look-up in less time than comparisons.
struct character_kinds {
    character_kind of[256]{};

    constexpr character_kinds() {
        for (char c : std::string_view("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_"))
            of[static_cast<unsigned char>(c)] = word;
        for (char c : std::string_view("(){}[=;/"))
            of[static_cast<unsigned char>(c)] = sign;
        of[static_cast<unsigned char>('\n')] = line_end;
    }
};
inline constexpr character_kinds kinds;

constexpr bool is_word(char c) {
    return kinds.of[static_cast<unsigned char>(c)] == word;
}

constexpr bool begins_with_prefix(const char* text, std::size_t left) {
    return left > 7 && text[0] == 'c' && text[1] == 'r' && text[2] == 'e' && text[3] == 'a' &&
           text[4] == 's' && text[5] == 'e' && text[6] == '_';
}

/// Where the rest of a line ends that is empty or a comment, its end included; else `at`.
constexpr std::size_t end_of_line(const char* text, std::size_t at, std::size_t size) {
    std::size_t i = at;
    while (i < size && text[i] == ' ')
        ++i;
    if (i + 1 < size && text[i] == '/' && text[i + 1] == '/')
        while (i < size && text[i] != '\n')
            ++i;
    return i == size ? size : text[i] == '\n' ? i + 1 : at;
}

}

/// Reads the definitions of a file; prototypes are none. One whose name does not begin with `crease_` counts
/// to that after it.
constexpr symbol_table read_symbols(const glsl_file& file) {
    symbol_table table{&file, {}, {}};
    // Plain indices and one loop: a compiler evaluates this for each character.
    const char* text = file.text.data();
    const std::size_t size = file.text.size();
    const reading::character_kind* const kinds = reading::kinds.of;
    definition own;
    symbol last = 0; // identifier just before
    bool is_named = false, is_function = false;
    int depth = 0;
    std::uint16_t line = 0;
    for (std::size_t i = 0; i < size;) {
        const char c = text[i];
        const reading::character_kind kind = kinds[static_cast<unsigned char>(c)];
        if (kind == reading::plain) {
            ++i;
        } else if (kind == reading::word) {
            last = 0;
            if (c == 'c' && reading::begins_with_prefix(text + i, size - i)) {
                last = crease_prefix;
                for (i += 7; i < size && kinds[static_cast<unsigned char>(text[i])] == reading::word; ++i)
                    last = (last ^ static_cast<unsigned char>(text[i])) * 16777619u;
                std::size_t known = own.first_reference;
                while (known < table.references.count && table.references.items[known] != last)
                    ++known;
                if (known == table.references.count)
                    table.references.add(last);
            } else {
                const std::size_t first = i++;
                while (i < size && kinds[static_cast<unsigned char>(text[i])] == reading::word)
                    ++i;
                if (c == 'm' && i - first == 4 && text[first + 1] == 'a' && text[first + 2] == 'i' &&
                    text[first + 3] == 'n')
                    last = main_symbol;
            }
        } else if (kind == reading::line_end) {
            ++i;
            ++line;
        } else if (c == '/' && i + 1 < size && text[i + 1] == '/') {
            while (i < size && text[i] != '\n')
                ++i;
        } else if (c == '/' && i + 1 < size && text[i + 1] == '*') {
            for (i += 2; i + 1 < size && !(text[i] == '*' && text[i + 1] == '/'); ++i)
                line = static_cast<std::uint16_t>(line + (text[i] == '\n'));
            i += 2;
        } else {
            if (depth == 0 && !is_named && last != 0 &&
                (c == '(' || c == '{' || c == '=' || c == '[' || c == ';')) {
                own.name = last;
                is_named = true;
                is_function = c == '(';
            }
            depth += c == '(' || c == '{' ? 1 : c == ')' || c == '}' ? -1 : 0;
            ++i;
            if (depth != 0 || !is_named || !(c == ';' || (c == '}' && is_function)))
                continue;
            const std::size_t next = reading::end_of_line(text, i, size);
            const bool ends_line = next > i && text[next - 1] == '\n';
            own.end = static_cast<std::uint16_t>(next);
            own.references = static_cast<std::uint16_t>(table.references.count - own.first_reference);
            if (c == ';' && is_function) // a prototype
                table.references.count = own.first_reference;
            else
                table.definitions.add(own);
            i = ends_line ? next - 1 : next; // the line's end is counted above
            own = {.begin = static_cast<std::uint16_t>(next),
                   .line = static_cast<std::uint16_t>(line + ends_line),
                   .first_reference = static_cast<std::uint16_t>(table.references.count)};
            is_named = false;
            last = 0;
        }
    }
    table.definitions.cut = table.definitions.cut || size > 0xffff;
    return table;
}

/// The symbols of a file, read once for all programs.
template <const glsl_file* File>
inline constexpr symbol_table symbols_of = read_symbols(*File);

}
