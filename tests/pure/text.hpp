// SPDX-License-Identifier: MIT
#pragma once

#include <crease/effect/pass.hpp>

#include <cstddef>
#include <string>
#include <string_view>

/// The program that a driver sees.
inline std::string joined(crease::array_view<const crease::piece> pieces) {
    std::string all;
    for (const crease::piece& each : pieces)
        all += each.text;
    return all;
}

constexpr bool contains(std::string_view text, std::string_view part) {
    return text.find(part) != std::string_view::npos;
}

/// The text after its first comment, which names the recipe.
constexpr std::string_view without_recipe(std::string_view text) {
    return text.substr(text.find('\n', text.find("// ")) + 1);
}

/// Whether the text is one line of comment and then `version`.
constexpr bool has_version(std::string_view text, std::string_view version) {
    return text.starts_with("// ") && without_recipe(text).starts_with(version);
}

/// What the program of a pass has of a file, empty where that is nothing.
inline std::string part_of(const crease::pass& pass, std::string_view name) {
    std::string all;
    for (const crease::piece& each : pass.pieces)
        if (each.name == name)
            all += each.text;
    return all;
}

/// Whether the program of a pass has a definition of a file.
inline bool has_part_of(const crease::pass& pass, std::string_view name) {
    return !part_of(pass, name).empty();
}
