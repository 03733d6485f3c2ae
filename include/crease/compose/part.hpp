// SPDX-License-Identifier: MIT
#pragma once

#include <crease/compose/glsl_file.hpp>
#include <crease/compose/role.hpp>
#include <crease/compose/step.hpp>
#include <crease/compose/trait.hpp>
#include <crease/effect/array_view.hpp>
#include <crease/effect/device_features.hpp>
#include <crease/effect/resource.hpp>

#include <string_view>

namespace crease {

/// An integer that a part takes as a template argument; in GLSL crease_<part>_<name>.
struct number {
    std::string_view name;
    int least, most; ///< inclusive
    int fallback;    ///< where a recipe gives none
    std::string_view meaning;
};

/// A real number that a host may change each frame; in GLSL crease_<part>_<name>.
struct setting {
    std::string_view name;
    float fallback;
    float least, most; ///< inclusive
    std::string_view meaning;
    bool shared = false; ///< one for all parts of the effect that name it and share it; crease_<name>
};

/// Cameras that a part adds to that of the picture.
struct view_request {
    unsigned count = 0;
    int count_number = -1; ///< index of the part's number that says how many more; -1: none
    int divisor = -1; ///< index of the part's number that divides the resolution of their pictures; -1: none
};

/// What a part says of itself. Parts are open: a host describes its own and composes it with those of crease.
///
/// Of the GLSL in its files a program holds the functions, structs and constants that it calls, and no other.
/// Where a name is defined more than once, the step's own comes first, then that of the parts in the order of
/// their roles, and then crease's default.
struct part {
    role kind;
    std::string_view name;    ///< in recipes and as the stem of its file, e.g. "hbao"
    std::string_view summary; ///< one line
    std::string_view source;  ///< paper, chapter, algorithm
    array_view<const glsl_file* const> files{};
    array_view<const number> numbers{};
    array_view<const setting> settings{};
    array_view<const resource> resources{};
    array_view<const step> steps{};
    array_view<const trait* const> needs{};
    array_view<const trait* const> offers{};
    array_view<const role> required_roles{}; ///< roles, else absent, of which the effect must have a part
    view_request further_views{};
    std::string_view extension{}; ///< of GLSL, that its text needs
    device_features features{};   ///< that it requires
};

/// The most numbers that a part may take.
inline constexpr std::size_t most_numbers = 4;

/// A part with its numbers: what a template argument of `effect` or a word of a recipe comes down to.
struct choice {
    const part* what = nullptr;
    int numbers[most_numbers]{};

    /// A number by its name; `otherwise` where the part takes none of that name.
    constexpr int number_of(std::string_view name, int otherwise = 0) const {
        for (std::size_t i = 0; i < what->numbers.size(); ++i)
            if (what->numbers[i].name == name)
                return numbers[i];
        return otherwise;
    }
};

/// What the shape of a resource may follow.
struct shape_of {
    array_view<const choice> parts; ///< of the effect
    const choice& own;              ///< whose resource it is
    unsigned views;                 ///< cameras, that of the picture included

    /// The part of a role; null where there is none.
    constexpr const choice* find(role r) const {
        for (const choice& c : parts)
            if (c.what->kind == r)
                return &c;
        return nullptr;
    }
    /// A number of the part of a role; `otherwise` where there is none.
    constexpr int number_of(role r, std::string_view name, int otherwise = 1) const {
        const choice* c = find(r);
        return c ? c->number_of(name, otherwise) : otherwise;
    }
    /// Whether any part of the effect offers a trait.
    constexpr bool offers(const trait* wanted) const {
        for (const choice& c : parts)
            if (has(c.what->offers, wanted))
                return true;
        return false;
    }
};

/// A type that names a part: it has `description`, `numbers` where the part takes any, and `needs` (a
/// `traits<...>`) where it needs something of another part.
template <class T>
concept a_part = requires {
    static_cast<const part*>(&T::description);
};

/// The choice that a part's type stands for.
template <a_part Part>
constexpr choice choice_of() {
    choice c{&Part::description, {}};
    if constexpr (requires { Part::numbers; }) {
        std::size_t i = 0;
        for (int value : Part::numbers)
            c.numbers[i++] = value;
    }
    return c;
}

}
