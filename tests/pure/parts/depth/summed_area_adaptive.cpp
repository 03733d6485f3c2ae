// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <memory>

namespace {

using namespace crease;

using four = effect<sample_box, summed_area_adaptive<4, 2>, mean_height<>>;

static_assert(offers<summed_area_adaptive<>, layers_of_areas>);

}

TEST_CASE("each level of splits adds three passes, and only the levels that the layers need are there") {
    const std::size_t passes[] = {8, 11, 11, 14, 14, 14, 14}; // of 2 to 8 layers
    for (int layers = 2; layers <= 8; ++layers) {
        CAPTURE(layers);
        const std::string text = "sample_box/summed_area_adaptive:" + std::to_string(layers) + "/mean_height";
        const auto composed = std::make_unique<composition>(recipe(std::string_view(text)));
        CHECK(composed->view().passes.size() == passes[layers - 2]);
    }
}

TEST_CASE("four layers are stored in four tables, and the others are differences") {
    const auto tables = std::ranges::find(four::resources, "area_tables", &resource::name);
    REQUIRE(tables != four::resources.end());
    CHECK(tables->layers == 4);
    for (std::string_view name : {"area_splits", "area_rows"}) // of one level
        CHECK(std::ranges::find(four::resources, name, &resource::name)->layers == 2);
    CHECK(four::passes[4].name == "split_1");
    CHECK(four::passes[7].name == "split_2");
    CHECK(contains(four::passes[7].pieces[0].text, "const int crease_summed_area_adaptive_split = 2;"));
    CHECK(contains(four::passes[8].pieces[0].text,
                   "const int crease_scan_first = 2;\nconst int crease_scan_end = 4;\n"));
}
