// SPDX-License-Identifier: MIT
#pragma once

#include <crease/compose/rules.hpp>

#include <cstddef>
#include <string_view>

namespace crease {

/// Types in an order.
template <class... Parts>
struct part_list {};

/// Parts that go well together, under a name.
struct preset_description {
    std::string_view name;          ///< behind "preset:" in recipes
    std::string_view summary;       ///< one line
    array_view<const choice> parts; ///< that make an effect; static
};

/// A type that names a preset: it has `parts`, a `part_list`, and `description`.
template <class T>
concept a_preset = requires {
    typename T::parts;
    static_cast<const preset_description*>(&T::description);
};

/// The choices of a `part_list`.
template <class Parts>
inline constexpr choice choices_in[] = {{}};
/// The same, of its parts.
template <class... Parts>
inline constexpr choice choices_in<part_list<Parts...>>[] = {choice_of<Parts>()...};

namespace combining {

constexpr bool same_role(const choice& a, const choice& b) {
    return a.what && b.what && a.what->kind == b.what->kind;
}

constexpr bool has_role_of(array_view<const choice> choices, const choice& wanted) {
    for (const choice& c : choices)
        if (same_role(c, wanted))
            return true;
    return false;
}

/// The parts of an effect as places in the list of a preset's parts and then those named behind it.
constexpr fixed_list<std::size_t, most_parts> order(array_view<const choice> preset,
                                                    array_view<const choice> named) {
    fixed_list<std::size_t, most_parts> places;
    for (std::size_t i = 0; i < preset.size(); ++i) {
        const bool first = !has_role_of({preset.data(), i}, preset[i]);
        if (!has_role_of(named, preset[i]))
            places.add(i);
        else if (first)
            for (std::size_t j = 0; j < named.size(); ++j)
                if (same_role(named[j], preset[i]))
                    places.add(preset.size() + j);
    }
    for (std::size_t j = 0; j < named.size(); ++j)
        if (!has_role_of(preset, named[j]))
            places.add(preset.size() + j);
    return places;
}

}

/// A preset's parts, where those that are named behind it take the place of those of the same role, filters
/// of all filters.
constexpr choice_list combine(array_view<const choice> preset, array_view<const choice> named) {
    choice_list all;
    for (std::size_t place : combining::order(preset, named))
        all.add(place < preset.size() ? preset[place] : named[place - preset.size()]);
    return all;
}

}
