// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

namespace {

using namespace crease;

using by_default = effect<sample_box, summed_area<>, mean_height<>>;
static_assert(!offers<area_layers, any_view>);
static_assert(recipe("sample_box/summed_area/mean_height/area_layers"));
static_assert(!recipe("directions/single_layer/hbao/area_layers"));

}

TEST_CASE("area_layers is the default of areas, and leaves out what rounding leaves of nothing") {
    const std::string_view whole = by_default::source<by_default::passes.size() - 1>();
    CHECK(contains(whole, "if (layer.texels >= 0.01)"));
    CHECK(contains(whole, "crease_fetch_area(tap.area)"));
    CHECK_FALSE(contains(whole, "crease_combine("));
}
