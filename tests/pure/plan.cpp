// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace crease;

constexpr plan planned(std::string_view text) {
    return make_plan(recipe(text).choices());
}

static_assert(planned("directions/single_layer/hbao").passes.size() == 1);
static_assert(planned("directions/single_layer/hbao/bilateral").passes.size() == 3);
static_assert(planned("directions/single_layer/hbao/reconstructed_normals").resources.size() == 3);

/// A name and a size of a picture of 641 x 359 texels with a guard band of 16.
struct sized {
    std::string name;
    unsigned width, height;
    bool operator==(const sized&) const = default;
};

template <class Items>
std::vector<sized> sizes_of(const Items& items) {
    std::vector<sized> all;
    for (const auto& each : items)
        all.push_back({std::string(each.name), each.size.width_of(641, 16), each.size.height_of(359, 16)});
    return all;
}

/// The size of each pass, image and capture of a recipe; `images` and `captures` in any order.
void check_sizes(std::string_view recipe_text, const std::vector<sized>& passes,
                 const std::vector<sized>& images, const std::vector<sized>& captures = {}) {
    CAPTURE(std::string(recipe_text));
    const recipe chosen(recipe_text);
    REQUIRE(chosen);
    const auto composed = std::make_unique<composition>(chosen);
    const effect_view view = composed->view();
    CHECK(sizes_of(view.passes) == passes);
    CHECK(sizes_of(view.captures) == captures);
    std::vector<sized> there = sizes_of(view.resources);
    REQUIRE(there.size() == images.size() + 1); // and the block of parameters
    for (const sized& each : images)
        CHECK_MESSAGE(std::ranges::find(there, each) != there.end(), each.name);
}

}

TEST_CASE("what stands before upsample runs at its fraction of the resolution, what stands after in full") {
    const plan p = planned("directions/single_layer/hbao/bilateral/upsample:4/bilateral");
    REQUIRE(p.passes.size() == 6);
    const unsigned divisors[] = {4, 4, 4, 1, 1, 1};
    const unsigned input_divisors[] = {4, 4, 4, 4, 1, 1};
    for (std::size_t i = 0; i < 6; ++i) {
        CHECK(p.passes[i].size.divisor == divisors[i]);
        CHECK(p.passes[i].input_divisor == input_divisors[i]);
        CHECK(p.resources[p.passes[i].outputs[0]].size.divisor == divisors[i]);
    }
}

TEST_CASE("two upsamplings multiply") {
    const plan p = planned("directions/single_layer/hbao/upsample:2/upsample:3");
    REQUIRE(p.passes.size() == 3);
    CHECK(p.passes[0].size.divisor == 6);
    CHECK(p.passes[1].size.divisor == 3);
    CHECK(p.passes[2].size.divisor == 1);
}

TEST_CASE("each pass reads what the one before it writes, in the encoding between passes") {
    const plan p = planned("directions/single_layer/hbao/bilateral/upsample");
    CHECK(p.passes[0].input == -1);
    for (std::size_t i = 1; i < p.passes.size(); ++i) {
        CHECK(p.passes[i].input == static_cast<int>(p.passes[i - 1].outputs[0]));
        CHECK(p.resources[p.passes[i - 1].outputs[0]].texels == visibility_depth_encoding.texels);
        CHECK(p.passes[i].last == (i + 1 == p.passes.size()));
    }
    CHECK(p.resources[p.passes[p.passes.size() - 1].outputs[0]].texels == visibility_encoding.texels);
    CHECK(p.resources[p.resources.size() - 1].life == lifetime::output);
}

TEST_CASE("sizes: a chain at half resolution, and a picture between two filters at full") {
    check_sizes("directions/single_layer/hbao/linearised_depth/bilateral/upsample:2/bilateral",
                {{"linearise", 673, 391},
                 {"visibility", 321, 180},
                 {"bilateral_x", 321, 180},
                 {"bilateral_y", 321, 180},
                 {"upsample", 641, 359},
                 {"bilateral_x", 641, 359},
                 {"bilateral_y", 641, 359}},
                {{"depth", 673, 391},
                 {"normal", 673, 391},
                 {"linearised_depth", 673, 391},
                 {"between_0", 321, 180},
                 {"between_1", 321, 180},
                 {"between_2", 321, 180},
                 {"between_3", 641, 359},
                 {"between_4", 641, 359},
                 {"visibility", 641, 359}});
}

TEST_CASE("sizes: two upsamplings, of two images each") {
    check_sizes("directions/single_layer/hbao/bent_cone/upsample:2/upsample:3",
                {{"visibility", 107, 60}, {"upsample", 214, 120}, {"upsample", 641, 359}},
                {{"depth", 673, 391},
                 {"normal", 673, 391},
                 {"between_0", 107, 60},
                 {"between_1", 214, 120},
                 {"visibility", 641, 359},
                 {"bent_cone", 641, 359}});
}

TEST_CASE("sizes: layers of two cameras, the second at a third of the resolution and without a band") {
    check_sizes("directions/stochastic_layers:4/hbao_plus/atomic_minimum/second_view:3",
                {{"pack_layers", 673, 391}, {"pack_layers", 214, 120}, {"visibility", 641, 359}},
                {{"depth", 673, 391},
                 {"normal", 673, 391},
                 {"subsets", 256, 257},
                 {"captured_layers", 673, 391},
                 {"second_captured_layers", 214, 120},
                 {"packed_layers", 673, 391},
                 {"visibility", 641, 359}},
                {{"layers", 673, 391}, {"second_captured_layers", 214, 120}});
}

TEST_CASE("sizes: tables at a quarter of the resolution, and their range") {
    const std::vector<sized> images{{"depth", 673, 391},       {"normal", 673, 391},
                                    {"area_tables", 193, 122}, {"range_of_columns", 641, 1},
                                    {"range", 1, 1},           {"visibility", 641, 359}};
    check_sizes("sample_box/summed_area:4/mean_height",
                {{"range_of_columns", 641, 1},
                 {"range_of_picture", 1, 1},
                 {"make_rows", 193, 122},
                 {"sum_columns", 193, 122},
                 {"visibility", 641, 359}},
                images);
    check_sizes("sample_box/mip_chain:3x4/mean_height",
                {{"range_of_columns", 641, 1},
                 {"range_of_picture", 1, 1},
                 {"level_0", 193, 122},
                 {"level_1", 193, 122},
                 {"level_2", 193, 122},
                 {"visibility", 641, 359}},
                images);
}

TEST_CASE("a multisampled image has the least power of 2 above 1 that holds the samples") {
    const unsigned samples[] = {2, 2, 4, 4, 8, 8, 8, 8, 16};
    for (unsigned count = 1; count <= 9; ++count) {
        CAPTURE(count);
        const plan p =
            planned("directions/stochastic_layers:" + std::to_string(count) + "/hbao/multisampled");
        const resource& captured = p.resources[p.index_of("captured_layers")];
        CHECK(captured.samples == samples[count - 1]);
        CHECK(captured.layers == 1);
        CHECK(!captured.arrayed);
    }
}

TEST_CASE("an array of captured layers has one for each sample, also where there is one and where there are "
          "two cameras") {
    for (const std::string second : {"", "/second_view"})
        for (unsigned count : {1u, 2u, 5u, 32u}) {
            const unsigned groups = count == 32 ? 8 : count == 5 ? 2 : 1; // of four
            CAPTURE(second);
            CAPTURE(count);
            const plan p = planned("directions/stochastic_layers:" + std::to_string(count) +
                                   "/hbao_plus/atomic_minimum" + second);
            for (const resource& r : p.resources)
                if (r.life == lifetime::captured) {
                    CHECK(r.layers == count);
                    CHECK(r.arrayed);
                    CHECK(r.samples == 1);
                }
            CHECK(p.resources[p.index_of("captured_layers")].life == lifetime::captured);
            CHECK(p.captures.size() == (second.empty() ? 1 : 2));
            CHECK(p.resources[p.index_of("packed_layers")].layers == groups * p.captures.size());
        }
}
