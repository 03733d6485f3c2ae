// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

#include <algorithm>

namespace {

using namespace crease;

using full = effect<sample_box, summed_area<>, mean_height<>>;
using quarter = effect<sample_box, summed_area<4>, mean_height<>>;

static_assert(offers<summed_area<>, layers_of_areas>);
static_assert(!offers<summed_area<>, depth_layers>);
static_assert(full::passes.size() == 5);

}

TEST_CASE("summed_area makes and sums rows into one image, and sums their columns into another") {
    CHECK(full::passes[2].covers == dispatch::rows);
    CHECK(full::passes[3].covers == dispatch::columns);
    CHECK(full::passes[2].bindings.back().name == "area_rows");
    CHECK(full::passes[3].bindings.back().name == "area_tables");
    CHECK(full::passes[3].bindings[0].name == "area_rows");
    CHECK(full::passes[3].bindings[0].how == access::sample);
    for (std::size_t i : {2u, 3u})
        CHECK(contains(full::passes[i].pieces[0].text,
                       i == 2 ? "const int crease_scan_axis = 0;" : "const int crease_scan_axis = 1;"));
    CHECK(part_of(full::passes[2], "depth/scan.glsl") == part_of(full::passes[3], "depth/scan.glsl"));
}

TEST_CASE("the tables are as much smaller than the picture as the number says") {
    for (const auto& [view, divisor] : {std::pair{full::view(), 1u}, {quarter::view(), 4u}}) {
        const resource* tables = nullptr;
        for (const resource& each : view.resources)
            if (each.name == "area_tables")
                tables = &each;
        REQUIRE(tables != nullptr);
        CHECK(tables->size.divisor == divisor);
        CHECK(tables->texels == format::rgba32_float);
        CHECK(tables->layers == 1);
        CHECK(view.passes[2].size.divisor == divisor);
        CHECK(view.passes.back().size.divisor == 1);
    }
}

TEST_CASE("the estimator says how many channels the tables have") {
    using of_depth = effect<box_area<>, summed_area<>, unsharp_mask>;
    const auto tables = std::ranges::find(of_depth::resources, "area_tables", &resource::name);
    REQUIRE(tables != of_depth::resources.end());
    CHECK(tables->texels == format::rg32_float);
    for (std::size_t i : {2u, 3u})
        CHECK(contains(of_depth::passes[i].pieces[0].text, "layout(rg32f, "));
}
