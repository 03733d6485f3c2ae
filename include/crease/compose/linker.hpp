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
        for (std::size_t i = 0; i < file.definitions.count; ++i) {
            entry& e = at(file.definitions.items[i].name);
            if (!e.what.from)
                e.what = {&file, static_cast<std::uint16_t>(i)};
        }
    }

    /// Takes in a definition, or a name that no file defines, with all that it refers to.
    constexpr void use(symbol name) {
        entry& e = at(name);
        if (e.is_used)
            return;
        e.is_used = true;
        if (!e.what.from)
            return;
        const linked what = e.what;
        const definition& own = what.from->definitions.items[what.index];
        for (std::size_t i = 0; i < own.references; ++i)
            use(what.from->references.items[own.first_reference + i]);
        order_.add(what);
    }

    constexpr bool is_used(symbol name) const {
        for (std::size_t i = name % capacity; table_[i].name != 0; i = (i + 1) % capacity)
            if (table_[i].name == name)
                return table_[i].is_used;
        return false;
    }

    /// What was taken in, callees first.
    constexpr const auto& order() const { return order_; }

    /// Whether there was too much for the tables.
    constexpr bool is_cut() const { return is_cut_ || order_.cut || count_ == capacity / 2; }

private:
    struct entry {
        symbol name = 0;
        bool is_used = false;
        linked what{};
    };
    static constexpr std::size_t capacity = 1024;

    constexpr entry& at(symbol name) {
        std::size_t i = name % capacity;
        while (table_[i].name != 0 && table_[i].name != name)
            i = (i + 1) % capacity;
        if (table_[i].name == 0) {
            if (count_ == capacity / 2)
                return rest_;
            ++count_;
            table_[i].name = name;
        }
        return table_[i];
    }

    entry table_[capacity]{};
    entry rest_; // for what does not fit
    std::size_t count_ = 0;
    fixed_list<linked, 192> order_;
    bool is_cut_ = false;
};

}
