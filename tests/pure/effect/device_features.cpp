// SPDX-License-Identifier: MIT
#include <crease/effect/device_features.hpp>

#include <doctest/doctest.h>

using namespace crease;

TEST_CASE("a device covers what it has all features of") {
    const device_features none, each[] = {{.extended_storage_formats = true},
                                          {.fragment_stores_and_atomics = true},
                                          {.subgroup_arithmetic = true},
                                          {.depth_samples = 4},
                                          {.centred_depth_samples = 8}};
    device_features all;
    for (const device_features& one : each) {
        CHECK(one.cover(none));
        CHECK(one.cover(one));
        CHECK_FALSE(none.cover(one));
        all |= one;
    }
    for (const device_features& one : each)
        CHECK(all.cover(one));
    CHECK_FALSE(device_features{.depth_samples = 4}.cover({.depth_samples = 4 | 8}));
}
