// SPDX-License-Identifier: MIT
#pragma once

/// @file
/// What parts require of each other.

#include <crease/compose/role.hpp>
#include <crease/effect/array_view.hpp>

#include <string_view>

namespace crease {

/// Something that one part requires and another offers: a kind of tap, an attribute of a layer. See
/// CREASE_TRAIT.
struct trait {
    role from;                 ///< who must offer it
    std::string_view sentence; ///< why an effect without it is refused
};

/// A list of traits, as a type and as the data in `part::needs` and `part::offers`.
template <class... Traits>
struct traits {
    static constexpr const trait* values[] = {&Traits::value...}; ///< the traits as data
    static constexpr array_view<const trait* const> list{values}; ///< a view of them
};

/// Whether a list has a trait.
constexpr bool has(array_view<const trait* const> list, const trait* wanted) {
    for (const trait* t : list)
        if (t == wanted)
            return true;
    return false;
}

/// Whether the part of type `Part` offers `Trait`.
template <class Part, class Trait>
constexpr bool offers = has(Part::description.offers, &Trait::value);

}

/// Defines a trait. `sentence_` says who needs what and who does not offer it: it is the static assertion and
/// the run-time refusal.
#define CREASE_TRAIT(name_, from_, sentence_)                                                                \
    struct name_ {                                                                                           \
        static constexpr ::crease::trait value{::crease::role::from_, sentence_};                            \
        template <class Needer, class Offerer>                                                               \
        static constexpr bool met() {                                                                        \
            static_assert(::crease::offers<Offerer, name_>, "crease::effect: " sentence_);                   \
            return ::crease::offers<Offerer, name_>;                                                         \
        }                                                                                                    \
    }
