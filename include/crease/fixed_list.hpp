// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string_view>

namespace crease {

/// A list of at most `Capacity` items in place, so that composing needs no allocation.
template <class Item, std::size_t Capacity>
struct fixed_list {
    Item items[Capacity]{};
    std::size_t count = 0;

    constexpr void add(const Item& item) {
        items[count++] = item;
    } // past Capacity: an error in a constant expression
    constexpr std::size_t size() const { return count; }
    constexpr bool full() const { return count == Capacity; }
    constexpr const Item* begin() const { return items; }
    constexpr const Item* end() const { return items + count; }
    constexpr const Item& operator[](std::size_t i) const { return items[i]; }
    constexpr Item& operator[](std::size_t i) { return items[i]; }
    constexpr const Item* data() const { return items; }
};

/// Text of at most `Capacity` characters in place. What does not fit is cut off, and `cut` says so.
template <std::size_t Capacity>
struct fixed_text {
    char characters[Capacity]{};
    std::size_t count = 0;
    bool cut = false;

    constexpr fixed_text& operator<<(std::string_view text) {
        // Plain indices: a compiler evaluates this for each character of an interface.
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
    constexpr std::string_view view() const { return {characters, count}; }
};

}
