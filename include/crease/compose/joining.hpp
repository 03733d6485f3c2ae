// SPDX-License-Identifier: MIT
#pragma once

#include <crease/effect/pass.hpp>

#include <array>
#include <cstddef>
#include <string_view>

namespace crease::joining {

constexpr std::size_t size_of(array_view<const piece> pieces) {
    std::size_t size = 0;
    for (const piece& each : pieces)
        size += each.text.size();
    return size;
}

/// The pieces of a program one after the other, NUL-terminated.
template <std::size_t Size>
constexpr std::array<char, Size + 1> join(array_view<const piece> pieces) {
    std::array<char, Size + 1> all{};
    char* to = all.data();
    for (const piece& each : pieces) {
        const char* from = each.text.data();
        for (std::size_t i = 0; i < each.text.size(); ++i)
            to[i] = from[i];
        to += each.text.size();
    }
    return all;
}

}
