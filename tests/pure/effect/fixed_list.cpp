// SPDX-License-Identifier: MIT
#include <crease/effect/fixed_list.hpp>

#include <doctest/doctest.h>

static_assert([] {
    crease::fixed_list<int, 3> list;
    list.add(4);
    list.add(5);
    return list.size() == 2 && list[1] == 5 && !list.full() && list.end() - list.begin() == 2;
}());

TEST_CASE("fixed_list leaves out what does not fit and says so") {
    crease::fixed_list<int, 2> list;
    list.add(1);
    list.add(2);
    CHECK(list.full());
    CHECK_FALSE(list.cut);
    list.add(3);
    CHECK(list.cut);
    CHECK(list.size() == 2);
    CHECK(list[1] == 2);
}
