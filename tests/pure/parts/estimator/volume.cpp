// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

namespace {

using namespace crease;

using by_lines = effect<sphere_lines<8>, single_layer, line_volume>;
using by_points = effect<sphere_points<8>, single_layer, point_volume>;

}

TEST_CASE("both estimators of volume count what is filled from a plane, and have a falloff of their own") {
    constexpr std::string_view share = "return whole > 0.0 ? max(filled / whole, 0.0) : 0.0;";
    CHECK(contains(by_lines::source<0>(), share));
    CHECK(contains(by_points::source<0>(), share));
    CHECK(get(by_lines::defaults, by_lines::settings, "line_volume.falloff") == 1);
    CHECK(get(by_points::defaults, by_points::settings, "point_volume.falloff") == 1);
}
