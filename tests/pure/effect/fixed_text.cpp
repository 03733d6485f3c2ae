// SPDX-License-Identifier: MIT
#include <crease/effect/fixed_text.hpp>

#include <doctest/doctest.h>

#include <limits>

TEST_CASE("fixed_text writes numbers") {
    crease::fixed_text<64> text;
    text << 0 << " " << -1 << " " << -7 << " " << 1023u << " " << std::numeric_limits<int>::min();
    CHECK(text.view() == "0 -1 -7 1023 -2147483648");
}

TEST_CASE("fixed_text cuts off what does not fit and says so") {
    crease::fixed_text<5> text;
    text << "four";
    CHECK_FALSE(text.cut);
    text << "s";
    CHECK_FALSE(text.cut);
    text << "f";
    CHECK(text.cut);
    CHECK(text.view() == "fours");
}
