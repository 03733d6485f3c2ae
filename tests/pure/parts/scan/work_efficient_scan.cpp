// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

using namespace crease;

TEST_CASE("work_efficient_scan is the scan where none is named, and no scan is there without tables") {
    using tables = effect<sample_box, summed_area<>, mean_height<>>;
    CHECK(has_part_of(tables::passes[2], "scan/work_efficient_scan.glsl"));
    using named = effect<sample_box, summed_area<>, mean_height<>, work_efficient_scan>;
    CHECK(without_recipe(named::source<2>()) == without_recipe(tables::source<2>()));
    CHECK(recipe("sample_box/summed_area/mean_height/work_efficient_scan"));
    CHECK_FALSE(recipe("directions/single_layer/hbao/work_efficient_scan"));
}
