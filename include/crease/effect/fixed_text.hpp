// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string_view>

namespace crease {

/// Text of at most `Capacity` characters in place. What does not fit is left out, and `cut` says so.
template <std::size_t Capacity>
struct fixed_text {
    char characters[Capacity]{}; ///< of which the first `count` are the text's
    std::size_t count = 0;       ///< characters that are there
    bool cut = false;            ///< whether something was left out

    /// Adds text, or a number in decimal, at the end.
    /// @{
    constexpr fixed_text& operator<<(std::string_view text) {
        // Plain indices: a compiler evaluates this for each character of a program.
        const char* from = text.data();
        const std::size_t at = count, room = Capacity - at;
        const std::size_t size = text.size() < room ? text.size() : room;
        cut = cut || text.size() > room;
        for (std::size_t i = 0; i < size; ++i)
            characters[at + i] = from[i];
        count = at + size;
        return *this;
    }
    // A compiler knows the length of a literal, and std::string_view counts it character by character.
    constexpr fixed_text& operator<<(const char* literal) {
        return *this << std::string_view(literal, __builtin_strlen(literal));
    }
    constexpr fixed_text& operator<<(int value) {
        char digits[12]{};
        std::size_t first = 12;
        long long rest = value < 0 ? -static_cast<long long>(value) : value;
        do
            digits[--first] = static_cast<char>('0' + rest % 10);
        while ((rest /= 10) != 0);
        if (value < 0)
            digits[--first] = '-';
        return *this << std::string_view(digits + first, 12 - first);
    }
    constexpr fixed_text& operator<<(unsigned value) { return *this << static_cast<int>(value); }
    /// @}
    /// The text so far, which lives as long as this.
    constexpr std::string_view view() const { return {characters, count}; }
};

}
