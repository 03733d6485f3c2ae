// SPDX-License-Identifier: MIT
#pragma once

#include <crease/part.hpp>

#include <cstddef>

namespace crease {

/// Numbers that are left open where programs are written once for all effects that differ only in these:
/// such a number stands for one of an effect's parts, and is less than any that a part takes.
namespace open_number {

inline constexpr int first = -0x7fffffff - 1;
inline constexpr int end = first + 1024; // more than all parts take

/// @param part   index among the parts of the effect
/// @param index  of the number of that part
constexpr int of(std::size_t part, std::size_t index) {
    return first + static_cast<int>(part * most_numbers + index);
}

constexpr bool is(int number) {
    return number < end;
}

/// The number that an open one stands for; any other is itself.
constexpr int value_of(int number, const choice* parts) {
    if (!is(number))
        return number;
    const auto at = static_cast<std::size_t>(number - first);
    return parts[at / most_numbers].numbers[at % most_numbers];
}

/// Whether nothing of an effect but the values of its constants depends on a number.
constexpr bool may_be(const part& p, std::size_t index) {
    return index < p.numbers.size() && p.numbers[index].in_glsl && p.kind != role::depth_source &&
           p.kind != role::depth_encoding && p.kind != role::second_view &&
           static_cast<int>(index) != p.upsampling;
}

}

}
