// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

namespace {

using namespace crease;

using three = effect<sample_box, n_buffer<3>, mean_height<>>;
static_assert(recipe("sample_box/n_buffer:10x4/mean_height"));
static_assert(!recipe("sample_box/n_buffer:11/mean_height"));
static_assert(!recipe("sample_box/mip_chain:0/mean_height"));

}

TEST_CASE("a pyramid of one level is a picture of its texels, beside an image that is cleared") {
    using one = effect<sample_box, n_buffer<1>, mean_height<>>;
    for (const resource& each : one::resources)
        if (each.name == "odd_levels") {
            CHECK(each.layers == 1);
            CHECK(each.cleared);
        }
    for (const resource& each : three::resources)
        CHECK_FALSE(each.cleared);
}

TEST_CASE("each level of a pyramid is a pass of its own, and those above the last are not there") {
    constexpr std::string_view names[] = {"range_of_columns", "range_of_picture", "level_0",
                                          "level_1",          "level_2",          "visibility"};
    REQUIRE(three::passes.size() == std::size(names));
    for (std::size_t i = 0; i < std::size(names); ++i)
        CHECK(three::passes[i].name == names[i]);
    CHECK(contains(three::source<4>(), "const int crease_areas_level = 2;"));
    CHECK(contains(three::source<3>(), "imageStore(crease_odd_levels, "));
    CHECK(contains(three::source<4>(), "imageStore(crease_even_levels, "));
    CHECK(three::passes[4].group_width() == areas::wide);
    CHECK(three::passes[4].group_height() == areas::flat);
}
