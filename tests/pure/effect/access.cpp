// SPDX-License-Identifier: MIT
#include <crease/effect/access.hpp>

#include <doctest/doctest.h>

#include <initializer_list>

using namespace crease;

TEST_CASE("which accesses write, and which have a descriptor") {
    struct expectation {
        crease::access how; // POSIX has an access too
        bool writes, descriptor;
    };
    for (const expectation& each : {expectation{crease::access::uniform, false, true},
                                    {crease::access::sample, false, true},
                                    {crease::access::load, false, true},
                                    {crease::access::store, true, true},
                                    {crease::access::modify, true, true},
                                    {crease::access::attachment, true, false},
                                    {crease::access::result, true, false}}) {
        CAPTURE(static_cast<int>(each.how));
        CHECK(writes(each.how) == each.writes);
        CHECK(has_descriptor(each.how) == each.descriptor);
    }
}
