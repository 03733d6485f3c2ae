// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace crease::tools {

/// The median; of an even count the greater of the middle two.
/// @param numbers  at least one
template <class Number>
Number median(std::vector<Number> numbers) {
    const auto half = numbers.begin() + static_cast<std::ptrdiff_t>(numbers.size() / 2);
    std::nth_element(numbers.begin(), half, numbers.end());
    return *half;
}

}
