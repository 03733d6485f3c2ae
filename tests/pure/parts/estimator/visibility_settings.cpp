// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include <doctest/doctest.h>

TEST_CASE("every estimator reads strength and exponent, which are the effect's own") {
    for (const crease::part* p : crease::all_parts) {
        if (p->kind != crease::role::estimator)
            continue;
        CAPTURE(p->name);
        unsigned found = 0;
        for (const crease::setting& s : p->settings) {
            const bool is_one = s.name == "strength" || s.name == "exponent";
            found += is_one;
            CHECK(s.shared == is_one);
            if (is_one) {
                CHECK(s.fallback >= s.least);
                CHECK(s.fallback <= s.most);
                CHECK(
                    (s.name == "strength" ? s.least == 0 : s.least > 0)); // a power of 0 would make all open
            }
        }
        CHECK(found == 2);
    }
}
