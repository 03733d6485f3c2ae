// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstring>
#include <memory>
#include <new>
#include <string_view>
#include <type_traits>
#include <vector>

namespace crease::c {

/// Memory that lives and goes as one: what a composition gives out.
class arena {
public:
    /// Text with the NUL that C wants.
    char* text(std::string_view from) {
        char* copy = allocate<char>(from.size() + 1);
        if (!from.empty())
            std::memcpy(copy, from.data(), from.size());
        return copy;
    }

    /// An object that nothing has to destroy.
    template <class Item>
    const Item* keep(const Item& item) {
        return new (allocate<Item>(1)) Item(item);
    }

    /// Pointers to what `convert` makes of each of `items`.
    template <class List, class Convert>
    auto list(const List& items, const Convert& convert) {
        using item = std::remove_cvref_t<decltype(convert(items[0]))>;
        const item** all = allocate<const item*>(items.size());
        for (std::size_t i = 0; i < items.size(); ++i)
            all[i] = keep(convert(items[i]));
        return all;
    }

    /// So many objects, all of whose bytes are 0.
    template <class Item>
    Item* allocate(std::size_t count) {
        static_assert(std::is_trivially_destructible_v<Item> && alignof(Item) <= alignof(std::max_align_t));
        blocks_.push_back(std::make_unique<std::byte[]>(count * sizeof(Item)));
        return reinterpret_cast<Item*>(blocks_.back().get());
    }

private:
    std::vector<std::unique_ptr<std::byte[]>> blocks_;
};

}
