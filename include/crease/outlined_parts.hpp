// SPDX-License-Identifier: MIT
#pragma once

#include <crease/open_number.hpp>

#include <cstddef>
#include <utility>

namespace crease {

namespace outlining {

/// A part at its place among those of an effect, with the numbers left open that may be.
template <const part* What, int... Numbers>
struct open_part {
    static constexpr choice value{What, {Numbers...}};
};

template <class Part, std::size_t Place, std::size_t Index>
constexpr int number_at() {
    if constexpr (open_number::may_be(Part::description, Index))
        return open_number::of(Place, Index);
    else
        return choice_of<Part>().numbers[Index];
}

template <class Part, std::size_t Place>
struct opened {
    static_assert(most_numbers == 4);
    using type = open_part<&Part::description, number_at<Part, Place, 0>(), number_at<Part, Place, 1>(),
                           number_at<Part, Place, 2>(), number_at<Part, Place, 3>()>;
};

template <class... OpenParts>
struct open_parts {
    static constexpr choice parts[] = {OpenParts::value...};
};

template <class Places, class... Parts>
struct open_all;
template <std::size_t... Place, class... Parts>
struct open_all<std::index_sequence<Place...>, Parts...> {
    using type = open_parts<typename opened<Parts, Place>::type...>;
};

}

/// What effects have in common that differ only in numbers that may be left open: `parts`, an array of
/// choices.
template <class... Parts>
using outlined_parts =
    typename outlining::open_all<std::make_index_sequence<sizeof...(Parts)>, Parts...>::type;

}
