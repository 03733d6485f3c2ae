// SPDX-License-Identifier: MIT
#pragma once

#include <crease/pass.hpp>

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

/// The program that a driver sees.
inline std::string joined(std::span<const crease::piece> pieces) {
    std::string all;
    for (const crease::piece& each : pieces)
        all += each.text;
    return all;
}

constexpr bool contains(std::string_view text, std::string_view part) {
    return text.find(part) != std::string_view::npos;
}

/// The piece's text, empty where the pass has none of that name.
inline std::string_view piece_of(const crease::pass& pass, std::string_view name) {
    for (const crease::piece& each : pass.pieces)
        if (each.name == name)
            return each.text;
    return {};
}
