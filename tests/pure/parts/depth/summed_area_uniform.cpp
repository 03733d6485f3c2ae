// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include <doctest/doctest.h>

#include <algorithm>

namespace {

using namespace crease;

using effect_of_9 = effect<sample_box, summed_area_uniform<9, 2>, mean_height<>>;

static_assert(offers<summed_area_uniform<>, layers_of_areas>);
static_assert(effect_of_9::passes.size() == 6);

}

TEST_CASE("summed_area_uniform stores a table for each layer") {
    const auto tables = std::ranges::find(effect_of_9::resources, "area_tables", &resource::name);
    REQUIRE(tables != effect_of_9::resources.end());
    CHECK(tables->layers == 9);
    CHECK(tables->arrayed);
    CHECK(tables->size.divisor == 2);
}

TEST_CASE("more than 64 layers are refused") {
    CHECK(recipe("sample_box/summed_area_uniform:64/mean_height"));
    CHECK_FALSE(recipe("sample_box/summed_area_uniform:65/mean_height"));
}
