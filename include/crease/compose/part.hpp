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
    std::string_view name;    ///< e.g. "steps"
    int least;                ///< the least value allowed
    int most;                 ///< the greatest value allowed
    int fallback;             ///< where a recipe gives none
    std::string_view meaning; ///< in a few words
};

/// A real number that a host may change each frame; in GLSL crease_<part>_<name>.
struct setting {
    std::string_view name;    ///< e.g. "bias"
    float fallback;           ///< what the part recommends
    float least;              ///< the least value allowed
    float most;               ///< the greatest value allowed
    std::string_view meaning; ///< in a few words, with the unit
    bool shared = false;      ///< one for all parts of the effect that name it and share it; crease_<name>
};

/// Cameras that a part adds to that of the picture.
struct view_request {
    unsigned count = 0;    ///< how many
    int count_number = -1; ///< index of the part's number that says how many more; -1: none
    int divisor = -1; ///< index of the part's number that divides the resolution of their pictures; -1: none
};

/// What a part says of itself. Parts are open: a host describes its own and composes it with those of crease.
///
/// Of the GLSL in its files a program holds the functions, structs and constants that it calls, and no other.
/// Where a name is defined more than once, the step's own comes first, then that of the parts in the order of
/// their roles, and then crease's default.
struct part {
    role kind;                                       ///< what it does in an effect
    std::string_view name;                           ///< in recipes and as the stem of its file, e.g. "hbao"
    std::string_view summary;                        ///< one line
    std::string_view source;                         ///< paper, chapter, algorithm
    array_view<const glsl_file* const> files{};      ///< its GLSL
    array_view<const files_where> widened{};         ///< before these, each where more is needed of the part
    array_view<const glsl_file* const> main_files{}; ///< before both, in the main pass alone
    array_view<const number> numbers{};              ///< whole numbers: specialization constants
    array_view<const setting> settings{};            ///< real numbers that a host may change each frame
    array_view<const resource> resources{};          ///< images and buffers that it reads or fills
    array_view<const step> steps{};                  ///< passes of its own beside the main pass
    array_view<const trait* const> needs{};          ///< that the part of another role must offer
    array_view<const trait* const> offers{};         ///< that others may need
    array_view<const role> required_roles{}; ///< roles, else absent, of which the effect must have a part
    view_request further_views{};            ///< cameras that it adds
    std::string_view extension{};            ///< of GLSL, that its text needs
    device_features features{};              ///< that it requires
};

/// The most numbers that a part may take.
inline constexpr std::size_t most_numbers = 5;

/// A value that an effect recommends in place of its part's.
struct setting_value {
    std::string_view name; ///< of a setting of the part
    float value;           ///< in its range
};

/// A part with its numbers: what a template argument of `effect` or a word of a recipe comes down to.
struct choice {
    const part* what = nullptr;                 ///< static
    int numbers[most_numbers]{};                ///< in the order of `part::numbers`
    array_view<const setting_value> settings{}; ///< that differ from what the part recommends; static

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
    /// Whether any part of the effect needs a trait of another.
    constexpr bool needs(const trait* wanted) const {
        for (const choice& c : parts)
            if (has(c.what->needs, wanted))
                return true;
        return false;
    }
};

/// A type that names a part: it has `description`, `numbers` where the part takes any, `needs` (a
/// `traits<...>`) where it needs something of another part, and `recommended`, of `setting_value`, where it
/// stands for the part with other settings.
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
    if constexpr (requires { Part::recommended; })
        c.settings = Part::recommended;
    return c;
}

}
