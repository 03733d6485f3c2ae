// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

namespace {

using namespace crease;

using oriented = effect<sample_box, summed_area<>, mean_height<>>;

static_assert(!recipe("directions/summed_area/mean_height"));
static_assert(!recipe("sample_box/single_layer/mean_height"));
static_assert(!recipe("directions/summed_area/hbao"));

}

TEST_CASE("mean_height recommends its settings, and layers of areas count by the number of their texels") {
    for (const setting& each : mean_height<>::reads)
        CHECK(get(oriented::defaults, oriented::settings, each.name) == each.fallback);
    CHECK(has_part_of(oriented::passes.back(), "traversal/area_layers.glsl"));
    CHECK(contains(oriented::source<4>(), "const int crease_mean_height_oriented = 1;"));
}
