// SPDX-License-Identifier: MIT
#pragma once

#include <crease/effect/pass.hpp>

#include <cstddef>
#include <cstring>
#include <string_view>

namespace crease::joining {

constexpr std::size_t size_of(array_view<const piece> pieces) {
    std::size_t size = 0;
    for (const piece& each : pieces)
        size += each.text.size();
    return size;
}

/// The pieces of a program one after the other, NUL-terminated. They are joined at run time, as a compiler
/// would take longer for that than for all else together.
template <std::size_t Size>
struct text {
    char characters[Size + 1];

    explicit text(array_view<const piece> pieces) {
        char* to = characters;
        for (const piece& each : pieces) {
            std::memcpy(to, each.text.data(), each.text.size());
            to += each.text.size();
        }
        *to = '\0';
    }
    std::string_view view() const { return {characters, Size}; }
};

}
