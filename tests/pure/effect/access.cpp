// SPDX-License-Identifier: MIT
#include <crease/effect/access.hpp>

#include <doctest/doctest.h>

#include <initializer_list>

using namespace crease;

TEST_CASE("which accesses write, and which have a descriptor") {
    struct expectation {
        access how;
        bool writes, descriptor;
    };
    for (const expectation& each : {expectation{access::uniform, false, true},
                                    {access::sample, false, true},
                                    {access::load, false, true},
                                    {access::store, true, true},
                                    {access::modify, true, true},
                                    {access::attachment, true, false},
                                    {access::result, true, false}}) {
        CAPTURE(static_cast<int>(each.how));
        CHECK(writes(each.how) == each.writes);
        CHECK(has_descriptor(each.how) == each.descriptor);
    }
}
