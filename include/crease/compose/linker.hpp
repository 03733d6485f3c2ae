// SPDX-License-Identifier: MIT
#pragma once

#include <crease/compose/symbols.hpp>
#include <crease/effect/fixed_list.hpp>

#include <cstddef>
#include <cstdint>

namespace crease {

/// Finds the definitions that a program calls, each after those that it calls itself.
class linker {
public:
    /// A definition of a file.
    struct linked {
        const symbol_table* from = nullptr;
        std::uint16_t index = 0;
    };

    /// Adds a file. What is defined already stays as it is.
    constexpr void add(const symbol_table& file) {
        is_cut_ = is_cut_ || file.definitions.cut || file.references.cut;
        const definition* definitions = file.definitions.items;
        for (std::size_t i = 0; i < file.definitions.count; ++i) {
            const std::size_t at = place_of(definitions[i].name);
            if (!from_[at]) {
                from_[at] = &file;
                index_[at] = static_cast<std::uint16_t>(i);
            }
        }
    }

    /// Takes in a definition, or a name that no file defines, with all that it refers to.
    constexpr void use(symbol name) {
        const std::size_t at = place_of(name);
        if (!is_used_[at])
            take_in(at);
    }

    /// Takes in what the definition that was taken in last comes to call.
    constexpr void use_in_last(symbol name) {
        const linked last = order_[--order_.count];
        use(name);
        order_.add(last);
    }

    constexpr bool is_used(symbol name) const {
        for (std::size_t i = name % capacity; names_[i] != 0; i = (i + 1) % capacity)
            if (names_[i] == name)
                return is_used_[i];
        return false;
    }

    /// What was taken in, callees first.
    constexpr const auto& order() const { return order_; }

    /// Whether there was too much for the tables.
    constexpr bool is_cut() const { return is_cut_ || order_.cut || count_ == capacity / 2; }

private:
    static constexpr std::size_t capacity = 1024;

    constexpr void take_in(std::size_t at) {
        is_used_[at] = true;
        const symbol_table* from = from_[at];
        if (!from)
            return;
        const definition& own = from->definitions.items[index_[at]];
        const symbol* references = from->references.items + own.first_reference;
        for (std::size_t i = 0; i < own.references; ++i) {
            const symbol name = references[i];
            // Most names stand where they are looked for first, and a compiler takes its time for each call.
            std::size_t next = name % capacity;
            if (names_[next] != name)
                next = place_of(name);
            if (!is_used_[next])
                take_in(next);
        }
        order_.add({from, index_[at]});
    }

    constexpr std::size_t place_of(symbol name) {
        std::size_t i = name % capacity;
        while (names_[i] != 0 && names_[i] != name)
            i = (i + 1) % capacity;
        if (names_[i] == 0) {
            if (count_ == capacity / 2)
                return capacity; // for all that does not fit
            ++count_;
            names_[i] = name;
        }
        return i;
    }

    // Arrays of their own, as a compiler is quicker at these than at structs.
    symbol names_[capacity + 1] = {};
    const symbol_table* from_[capacity + 1] = {};
    std::uint16_t index_[capacity + 1] = {};
    bool is_used_[capacity + 1] = {};
    std::size_t count_ = 0;
    fixed_list<linked, 192> order_;
    bool is_cut_ = false;
};

}
