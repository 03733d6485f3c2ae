// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace crease {

/// A view of an array that outlives it; a std::span is made of one where a host wants that. A `std::span`
/// costs a compiler milliseconds for each type and length of array that it is made of.
template <class Item>
struct array_view {
    Item* items = nullptr; ///< the first of them
    std::size_t count = 0; ///< how many

    constexpr array_view() = default;
    /// Of `how_many` items that stand one after the other.
    constexpr array_view(Item* first, std::size_t how_many) : items(first), count(how_many) {}
    /// Of an array in C++.
    template <std::size_t Count>
    constexpr array_view(Item (&all)[Count]) : items(all), count(Count) {}
    /// Of a list with `data()` and `size()`: a std::array, std::vector or std::span.
    template <class List>
    requires requires(List& all) { static_cast<Item*>(all.data()); }
    constexpr array_view(List& all) : items(all.data()), count(all.size()) {}

    /// As a std::span has them; an index must be less than the size.
    /// @{
    constexpr Item* begin() const { return items; }
    constexpr Item* end() const { return items + count; }
    constexpr Item* data() const { return items; }
    constexpr std::size_t size() const { return count; }
    constexpr bool empty() const { return count == 0; }
    constexpr Item& operator[](std::size_t i) const { return items[i]; }
    constexpr Item& front() const { return items[0]; }
    constexpr Item& back() const { return items[count - 1]; }
    /// @}
};

}
