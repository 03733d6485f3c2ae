// SPDX-License-Identifier: MIT
#include <crease/effect/array_view.hpp>

#include <doctest/doctest.h>

#include <array>
#include <span>
#include <vector>

namespace {

constexpr int numbers[] = {3, 1, 4};
constexpr crease::array_view<const int> view = numbers;
static_assert(view.size() == 3 && view.front() == 3 && view.back() == 4 && view[1] == 1);
static_assert(crease::array_view<const int>().empty());

int sum(crease::array_view<const int> all) {
    int total = 0;
    for (int each : all)
        total += each;
    return total;
}

}

TEST_CASE("an array_view is made of any list, and a span of it") {
    CHECK(sum(numbers) == 8);
    const std::array two{1, 2};
    std::vector three{1, 2, 3};
    const auto first = std::span(numbers).first(2);
    CHECK(sum(two) == 3);
    CHECK(sum(three) == 6);
    CHECK(sum(first) == 4);
    CHECK(std::span<const int>(view).size() == 3);
}
