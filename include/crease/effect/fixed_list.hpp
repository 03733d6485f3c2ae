// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace crease {

/// A list of at most `Capacity` items in place, so that composing needs no allocation. What does not fit is
/// left out, and `cut` says so.
template <class Item, std::size_t Capacity>
struct fixed_list {
    static constexpr std::size_t capacity = Capacity; ///< the most items
    Item items[Capacity]{};                           ///< of which the first `count` are the list's
    std::size_t count = 0;                            ///< items that are there
    bool cut = false;                                 ///< whether something was left out

    /// Adds an item at the end, if there is room.
    constexpr void add(const Item& item) {
        if (count == Capacity)
            cut = true;
        else
            items[count++] = item;
    }
    /// As a std::vector has them; an index must be less than the size.
    /// @{
    constexpr std::size_t size() const { return count; }
    /// Whether there is no room for another.
    constexpr bool full() const { return count == Capacity; }
    constexpr const Item* begin() const { return items; }
    constexpr const Item* end() const { return items + count; }
    constexpr const Item& operator[](std::size_t i) const { return items[i]; }
    constexpr Item& operator[](std::size_t i) { return items[i]; }
    constexpr const Item* data() const { return items; }
    /// @}
};

}
