// SPDX-License-Identifier: MIT
#pragma once

#include <version>

// Debian's emscripten has a C++ library from before std::bit_cast.
#ifndef __cpp_lib_bit_cast
namespace std {
template <class To, class From>
constexpr To bit_cast(const From& from) noexcept {
    return __builtin_bit_cast(To, from);
}
}
#endif
