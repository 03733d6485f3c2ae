// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include <doctest/doctest.h>

namespace {

using namespace crease;

constexpr const trait* kinds_of_taps[] = {&screen_taps::value, &point_taps::value, &line_taps::value,
                                          &window_taps::value, &area_taps::value,  &slice_taps::value};

}

TEST_CASE(
    "every sampler says which taps it proposes, and every estimator or source takes some of a sampler") {
    for (const part* p : all_parts) {
        if (p->kind != role::sampler)
            continue;
        CAPTURE(p->name);
        unsigned kinds = 0;
        for (const trait* kind : kinds_of_taps)
            kinds += has(p->offers, kind);
        CHECK(kinds >= 1);
    }
    for (const trait* kind : kinds_of_taps) {
        CHECK(kind->from == role::sampler);
        CHECK_FALSE(kind->sentence.empty());
    }
}

TEST_CASE("taps in order are taps on the screen too") {
    for (const part* p : all_parts)
        if (has(p->offers, &ordered_taps::value))
            CHECK(has(p->offers, &screen_taps::value));
}
