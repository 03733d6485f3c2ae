// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

namespace {

using namespace crease;

static_assert(recipe("sample_box/summed_area/mean_height/area_layers"));
static_assert(!recipe("directions/single_layer/hbao/area_layers"));

}

TEST_CASE("area_layers is the traversal of areas where none is named") {
    using areas = effect<sample_box, summed_area_uniform<4>, mean_height<>>;
    CHECK(has_part_of(areas::passes.back(), "traversal/area_layers.glsl"));
    CHECK_FALSE(has_part_of(areas::passes.back(), "traversal/all_layers.glsl"));
}
