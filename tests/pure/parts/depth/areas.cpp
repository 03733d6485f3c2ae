// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include <doctest/doctest.h>

#include <algorithm>

namespace {

using namespace crease;

resource tables_of(const effect_view& of) {
    const auto found = std::ranges::find(of.resources, "area_tables", &resource::name);
    REQUIRE(found != of.resources.end());
    return *found;
}

}

TEST_CASE("there are as many tables as layers or levels, smaller by the divisor") {
    const resource layers = tables_of(effect<sample_box, summed_area_uniform<7, 2>, mean_height<>>::view());
    CHECK(layers.layers == 7);
    CHECK(layers.size.divisor == 2);
    CHECK(layers.size.guarded);
    const resource levels = tables_of(effect<sample_box, n_buffer<5, 4>, mean_height<>>::view());
    CHECK(levels.layers == 5);
    CHECK(levels.size.divisor == 4);
    const resource one = tables_of(effect<sample_box, summed_area<>, mean_height<>>::view());
    CHECK(one.layers == 1);
    CHECK(one.arrayed);
}

TEST_CASE("two channels hold one value and the count, four hold more") {
    CHECK(tables_of(effect<sample_box, summed_area<>, mean_height<>>::view()).texels == format::rgba32_float);
    CHECK(tables_of(effect<box_area<>, summed_area<>, unsharp_mask>::view()).texels == format::rg32_float);
}

TEST_CASE("summed-area tables require a scan, pyramids none") {
    for (const part* p : all_parts) {
        if (!has(p->offers, &layers_of_areas::value))
            continue;
        CAPTURE(p->name);
        const bool tables = p->name.starts_with("summed_area");
        CHECK(p->required_roles.size() == (tables ? 1 : 0));
        CHECK(std::ranges::count(p->required_roles, role::scan) == (tables ? 1 : 0));
        CHECK(has(p->needs, &area_taps::value));
        CHECK(has(p->needs, &area_means::value));
        CHECK(p->steps[0].name == "range_of_columns");
        CHECK(p->steps[1].name == "range_of_picture");
    }
}
