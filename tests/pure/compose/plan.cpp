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
static_assert(planned("directions:5/single_layer/hbao").recipe.view() ==
              "directions:5x4x2/single_layer/hbao");

const resource& resource_of(const plan& p, std::string_view name) {
    return p.resources[static_cast<std::size_t>(p.index_of(name, 0))];
}

namespace host {

constexpr glsl_file count_glsl{"host/count.glsl", R"(
void crease_build(ivec2 texel) { imageStore(crease_counts, texel, vec4(1.0)); }
)"};
constexpr const glsl_file* files[] = {&count_glsl};
constexpr std::string_view filled[] = {"counts"};
constexpr resource images[] = {{.name = "counts", .texels = format::r32_float, .life = lifetime::report}};
constexpr step steps[] = {
    {.name = "last", .files = files, .kind = step_kind::texels, .after = true, .writes = filled},
    {.name = "twice",
     .files = files,
     .kind = step_kind::texels,
     .writes = filled,
     .times = 2,
     .per_view = true},
};
/// Noise, as its role is one of the first.
constexpr part counting{.kind = role::noise,
                        .name = "counting",
                        .summary = "",
                        .source = "",
                        .resources = images,
                        .steps = steps};

}

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

/// The size of each pass and image of a recipe; `images` in any order.
void check_sizes(std::string_view recipe_text, const std::vector<sized>& passes,
                 const std::vector<sized>& images) {
    CAPTURE(std::string(recipe_text));
    const recipe chosen(recipe_text);
    REQUIRE(chosen);
    const auto composed = std::make_unique<composition>(chosen);
    const effect_view view = composed->view();
    CHECK(sizes_of(view.passes) == passes);
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
        CHECK(p.resources[p.passes[i - 1].outputs[0]].texels == format::rg32_uint);
        CHECK(p.passes[i].last == (i + 1 == p.passes.size()));
    }
    CHECK(p.resources[p.passes[p.passes.size() - 1].outputs[0]].texels == format::r8_unorm);
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
                {{"capture_layers", 673, 391},
                 {"captured_layers_1", 214, 120},
                 {"pack_layers", 673, 391},
                 {"pack_layers", 214, 120},
                 {"visibility", 641, 359}},
                {{"depth", 673, 391},
                 {"normal", 673, 391},
                 {"subsets", 256, 257},
                 {"captured_layers", 673, 391},
                 {"captured_layers_1", 214, 120},
                 {"packed_layers", 673, 391},
                 {"visibility", 641, 359}});
}

TEST_CASE("sizes: tables at a quarter of the resolution, and their range") {
    const auto images = [](const char* one, const char* other) {
        return std::vector<sized>{{"depth", 673, 391},     {"normal", 673, 391},         {one, 193, 122},
                                  {other, 193, 122},       {"range_of_columns", 641, 1}, {"range", 1, 1},
                                  {"visibility", 641, 359}};
    };
    check_sizes("sample_box/summed_area:4/mean_height",
                {{"range_of_columns", 641, 1},
                 {"range_of_picture", 1, 1},
                 {"make_rows", 193, 122},
                 {"sum_columns", 193, 122},
                 {"visibility", 641, 359}},
                images("area_tables", "area_rows"));
    check_sizes("sample_box/mip_chain:3x4/mean_height",
                {{"range_of_columns", 641, 1},
                 {"range_of_picture", 1, 1},
                 {"level_0", 193, 122},
                 {"level_1", 193, 122},
                 {"level_2", 193, 122},
                 {"visibility", 641, 359}},
                images("even_levels", "odd_levels"));
}

TEST_CASE("a multisampled image has the least power of 2 above 1 that holds the samples") {
    const unsigned samples[] = {2, 2, 4, 4, 8, 8, 8, 8, 16};
    for (unsigned count = 1; count <= 9; ++count) {
        CAPTURE(count);
        const plan p =
            planned("directions/stochastic_layers:" + std::to_string(count) + "/hbao/multisampled");
        const resource& captured = resource_of(p, "captured_layers");
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
            const std::size_t cameras = second.empty() ? 1 : 2;
            std::size_t captured = 0;
            for (const resource& r : p.resources)
                if (r.name.starts_with("captured_layers")) {
                    CHECK(r.life == lifetime::transient);
                    CHECK(r.cleared);
                    CHECK(r.layers == count);
                    CHECK(r.arrayed);
                    CHECK(r.samples == 1);
                    ++captured;
                }
            CHECK(captured == cameras);
            CHECK(resource_of(p, "packed_layers").layers == groups * cameras);
        }
}

TEST_CASE(
    "steps run before the main pass in the order of the roles, for each camera, or after the last filter") {
    using host::counting;
    static constexpr const part* known[] = {&directions_part::description,
                                            &stochastic_layers_part::description,
                                            &hbao_plus::description,
                                            &second_view_part::description,
                                            &bilateral_part::description,
                                            &atomic_minimum_part::description,
                                            &counting};
    const plan p = make_plan(
        recipe("directions/stochastic_layers/hbao_plus/bilateral/second_view/atomic_minimum/counting", known)
            .choices());
    REQUIRE_FALSE(p.refused);
    const std::vector<std::string_view> names{
        "twice",          "twice",          "twice",       "twice", // twice for each camera: a further view's
        "capture_layers", "capture_layers", "pack_layers", "pack_layers",
        "visibility",     "bilateral_x",    "bilateral_y", "last"};
    REQUIRE(p.passes.size() == names.size());
    for (std::size_t i = 0; i < names.size(); ++i)
        CHECK(p.passes[i].what->name == names[i]);
    const unsigned views[] = {0, 0, 1, 1, 0, 1, 0, 1, 0, 0, 0, 0};
    for (std::size_t i = 0; i < names.size(); ++i) {
        CAPTURE(i);
        CHECK(p.passes[i].view == views[i]);
    }
    CHECK(p.passes[4].stage == stage_kind::geometry);
    CHECK(p.passes[10].last);
    CHECK_FALSE(p.passes[11].last);
    CHECK(p.views == 2);
}

TEST_CASE("a camera's pass fills what is the camera's own, and what all share otherwise") {
    const plan p = planned("directions/stochastic_layers/hbao_plus/second_view");
    for (const planned_pass& pass : p.passes) {
        if (pass.what->name == "capture_layers")
            CHECK(p.resources[pass.outputs[0]].name ==
                  (pass.view == 0 ? "captured_layers" : "captured_layers_1"));
        if (pass.what->name == "pack_layers")
            CHECK(p.resources[pass.outputs[0]].name == "packed_layers");
    }
}

TEST_CASE("a step is there from a number of its part on") {
    for (int levels = 1; levels <= 5; ++levels) {
        CAPTURE(levels);
        const plan p = planned("sample_box/mip_chain:" + std::to_string(levels) + "/mean_height");
        CHECK(p.passes.size() == static_cast<std::size_t>(3 + levels));
    }
}

TEST_CASE("a step is there where a part of the effect needs its trait") {
    const auto count = [](const std::string& recipe) {
        return std::ranges::count(planned(recipe).passes, std::string_view("capture_surfaces"),
                                  [](const planned_pass& each) { return each.what->name; });
    };
    CHECK(count("directions/layer_array/hbao") == 0);
    CHECK(count("directions/layer_array/hbao/every_layer") == 1);
    CHECK(count("directions/linked_lists/hbao/every_layer") == 0);
}

TEST_CASE("settings of one name are one where both parts share it, and two where not") {
    constexpr setting sharpness[] = {{"sharpness", 1, 0, 2, "of its own"}};
    const part noise{.kind = role::noise, .name = "own", .summary = "", .source = "", .settings = sharpness};
    const choice chosen[] = {choice_of<directions<>>(),
                             choice_of<stochastic_layers<>>(),
                             choice_of<hbao>(),
                             {&noise, {}},
                             choice_of<bilateral<>>()};
    const plan p = make_plan(chosen);
    std::vector<std::string> names;
    for (const effect_setting& s : p.settings)
        names.push_back(std::string(s.part) + "." + std::string(s.name));
    CHECK(std::ranges::count(names, "bilateral.sharpness") == 1);
    CHECK(std::ranges::count(names, "own.sharpness") == 1);
    const plan twice = planned("directions/single_layer/hbao/bilateral:2/bilateral:4");
    CHECK(std::ranges::count(twice.settings, std::string_view("sharpness"), &effect_setting::name) == 1);
    CHECK(std::ranges::count(p.settings, std::string_view("strength"), &effect_setting::name) == 1);
}

TEST_CASE("a part that keeps a setting to itself does not share it with one that would") {
    constexpr setting own[] = {{"strength", 0.5f, 0, 1, "of its own"}};
    const part noise{.kind = role::noise, .name = "own", .summary = "", .source = "", .settings = own};
    const choice chosen[] = {
        choice_of<directions<>>(), choice_of<single_layer>(), choice_of<hbao>(), {&noise, {}}};
    const plan p = make_plan(chosen);
    CHECK(std::ranges::count(p.settings, std::string_view("strength"), &effect_setting::name) == 2);
    CHECK(std::ranges::count(p.settings, std::string_view("own"), &effect_setting::part) == 1);
}
