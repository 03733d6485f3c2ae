// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <memory>
#include <string>

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
    const resource one = tables_of(effect<sample_box, summed_area<>, mean_height<>>::view());
    CHECK(one.layers == 1);
    CHECK(one.arrayed);
}

TEST_CASE("two channels hold one value and the count, four hold more") {
    CHECK(tables_of(effect<sample_box, summed_area<>, mean_height<>>::view()).texels == format::rgba32_float);
    CHECK(tables_of(effect<box_area<>, summed_area<>, unsharp_mask>::view()).texels == format::rg32_float);
}

TEST_CASE("no pass of a source of areas reads and writes one image") {
    for (const part* p : all_parts)
        for (const step& each : p->steps)
            if (has(p->offers, &layers_of_areas::value)) {
                CAPTURE(p->name);
                CAPTURE(each.name);
                CHECK(each.how == access::store);
            }
}

TEST_CASE("sums are precise where the dialect has a word for that") {
    const auto sums_of = [](const std::string& dialect) {
        const std::string text = "sample_box/summed_area/mean_height" + dialect;
        const auto composed = std::make_unique<composition>(recipe(std::string_view(text)));
        REQUIRE(*composed);
        return joined(composed->view().passes[3].pieces);
    };
    for (const char* dialect : {"", "/opengl"})
        CHECK(contains(sums_of(dialect), "#define crease_precise precise\n"));
    for (const char* dialect : {"/glsl_es", "/webgpu"})
        CHECK(contains(sums_of(dialect), "#define crease_precise\n"));
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
