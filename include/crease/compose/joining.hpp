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

/// Writes the pieces of a program one after the other. They are joined at run time, as a compiler would take
/// longer for that than for all else together.
/// @param to  of size_of(pieces) characters
inline std::string_view join(array_view<const piece> pieces, char* to) {
    std::size_t size = 0;
    for (const piece& each : pieces) {
        std::memcpy(to + size, each.text.data(), each.text.size());
        size += each.text.size();
    }
    return {to, size};
}

}
