// SPDX-License-Identifier: MIT
#pragma once

#include <crease_c.h>

#include <crease/compose/part.hpp>

#include <cstdint>
#include <string_view>

namespace crease::c {

/// A part of crease as C has it; null of any other.
const crease_part* part_of(const part* which);

/// A setting as C has it; its names end with a NUL, as literals do.
template <class Setting>
constexpr crease_setting described(const Setting& s, const char* part, const char* name, const char* meaning,
                                   std::uint32_t offset) {
    return {part, name, meaning, s.fallback, s.least, s.most, s.shared, offset};
}

}
