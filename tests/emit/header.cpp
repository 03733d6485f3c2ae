// SPDX-License-Identifier: MIT
// What crease_add_shader makes of a recipe says what the C++ type of the same parts says, and runs as it
// does.
#include "desktop.hpp"
#include "drawn.hpp"
#include "fast.hpp"
#include "hosted.hpp"
#include "layered.hpp"
#include "newer.hpp"
#include "plain.hpp"
#include "small.hpp"
#include "table.hpp"

#include "same_effect.hpp"
#include "validated_device.hpp"

#include <crease/spirv.hpp>
#include <crease/vulkan/runner.hpp>

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace crease;

namespace {

using plain_type = effect<directions<4, 4>, single_layer, hbao, bilateral<>>;
using drawn_type = effect<directions<4, 4>, single_layer, hbao, bilateral<>, fragment>;
using layered_type =
    effect<directions<4, 4>, stochastic_layers<8>, hbao_plus, second_view<>, atomic_minimum<>>;
using hosted_type = effect<directions<4, 4>, single_layer, hbao, linearised_depth, functions<>>;
using table_type = effect<sample_box, summed_area<>, mean_height<>>;
using desktop_type = effect<hemisphere_points<16>, single_layer, ssao, upsample<2>, opengl_glsl>;

static_assert(plain::matches<plain_type> && small::matches<plain_type> && fast::matches<plain_type>);
static_assert(drawn::matches<drawn_type> && layered::matches<layered_type> && hosted::matches<hosted_type>);
static_assert(table::matches<table_type> && desktop::matches<desktop_type>);
static_assert(!plain::matches<drawn_type>);
static_assert(!plain::matches<effect<directions<4, 5>, single_layer, hbao, bilateral<>>>);

static_assert(plain::passes[1].name == "bilateral_x" && plain::passes[1].group_width() == 16);
static_assert(plain::passes[0].spirv[0] == 0x07230203 && plain::passes[0].pieces.empty());
static_assert(plain::resources.size() == plain_type::resources.size());
static_assert(plain::view().block_size() == plain_type::view().block_size());
static_assert(get(plain::defaults, plain::settings, "strength") ==
              get(plain_type::defaults, plain_type::settings, "strength"));
static_assert(newer::spirv::visibility[1] == 0x00010500); // SPIR-V of Vulkan 1.2
static_assert(sizeof small::spirv::visibility < sizeof plain::spirv::visibility * 6 / 10);

std::vector<std::uint32_t> filled(const resource& constant) {
    std::vector<std::uint32_t> texels(std::size_t{constant.size.fixed_width} * constant.size.fixed_height);
    constant.fill(texels);
    return texels;
}

/// All that both say, but for the text of what is SPIR-V.
void check_same(const effect_view& made, const effect_view& type) {
    CAPTURE(std::string(type.recipe));
    CHECK(made.recipe == type.recipe);
    CHECK(made.views == type.views);
    CHECK(made.features == type.features);
    CHECK(made.defaults == type.defaults);
    CHECK(compared::all_same(made.settings, type.settings));
    REQUIRE(made.resources.size() == type.resources.size());
    for (std::size_t i = 0; i < made.resources.size(); ++i) {
        resource own = made.resources[i], other = type.resources[i];
        if (own.fill && other.fill)
            CHECK(filled(own) == filled(other));
        CHECK((own.fill == nullptr) == (other.fill == nullptr));
        own.fill = other.fill = nullptr;
        CHECK(compared::same(own, other));
    }
    REQUIRE(made.passes.size() == type.passes.size());
    for (std::size_t i = 0; i < made.passes.size(); ++i) {
        const pass &own = made.passes[i], &other = type.passes[i];
        CHECK(own.name == other.name);
        CHECK(own.stage == other.stage);
        CHECK(own.dialect == other.dialect);
        CHECK(own.size == other.size);
        CHECK(own.covers == other.covers);
        CHECK(own.view == other.view);
        CHECK(compared::all_same(own.bindings, other.bindings));
        CHECK(compared::all_same(own.constants, other.constants));
        const bool is_program = own.stage == stage_kind::compute || own.stage == stage_kind::fragment;
        if (is_program && own.dialect == dialect_kind::vulkan) {
            CHECK(own.pieces.empty());
            CHECK(!own.spirv.empty());
            CHECK(own.vertex_spirv.empty() == other.vertex_pieces.empty());
        } else {
            CHECK(own.spirv.empty());
            CHECK(joined(own.pieces) == joined(other.pieces));
            CHECK(joined(own.vertex_pieces) == joined(other.vertex_pieces));
        }
    }
}

/// What the runner makes of a bumpy depth image.
std::vector<float> visibility_of(const effect_view& effect) {
    constexpr unsigned width = 61, height = 37;
    vulkan::runner runner(validated_device(), effect, width, height);
    std::vector<float> depth(std::size_t{width} * height), normal;
    for (std::size_t i = 0; i < depth.size(); ++i) {
        depth[i] = 0.3f + static_cast<float>(i * 37 % 101) / 1000;
        normal.insert(normal.end(), {0, 0, 1, 0});
    }
    runner.upload("depth", std::span<const float>(depth));
    runner.upload("normal", std::span<const float>(normal));
    parameters p = effect.defaults;
    constexpr float projection[16] = {1, 0, 0, 0, 0, -1.6f, 0, 0, 0, 0, 0, -1, 0, 0, 0.1f, 0};
    REQUIRE(set_projection(p.view, projection, width, height, {.depth_zero_to_one = true}));
    p.radius = 0.2f;
    runner.run(p);
    return runner.download("visibility");
}

}

TEST_CASE("a header says what the type says") {
    check_same(plain::view(), plain_type::view());
    check_same(small::view(), plain_type::view());
    check_same(fast::view(), plain_type::view());
    check_same(drawn::view(), drawn_type::view());
    check_same(layered::view(), layered_type::view());
    check_same(hosted::view(), hosted_type::view());
    check_same(table::view(), table_type::view());
    check_same(desktop::view(), desktop_type::view());
}

TEST_CASE("its SPIR-V is that of the type, and holds what it declares") {
    for (std::size_t i = 0; i < plain::passes.size(); ++i) {
        const spirv::words compiled = spirv::compile(plain_type::passes[i]);
        CHECK(spirv::compile(plain::passes[i]) == compiled);
        CHECK(spirv::mismatches(plain::view(), plain::passes[i], spirv::reflect(compiled)) ==
              std::vector<std::string>{});
        CHECK_NOTHROW(spirv::validate(spirv::compile(small::passes[i])));
        CHECK(small::passes[i].spirv.size() < plain::passes[i].spirv.size());
    }
}

TEST_CASE("its block is that of the type") {
    parameters p = plain::defaults;
    p.radius = 3;
    REQUIRE(set(p, plain::settings, "strength", 2));
    CHECK(plain::block(p) == plain_type::block(p));
}

TEST_CASE("the runner makes the same picture of a header as of the type, whatever was done to the SPIR-V") {
    const std::vector<float> expected = visibility_of(plain_type::view());
    CHECK(*std::ranges::min_element(expected) < 0.9f);
    CHECK(visibility_of(plain::view()) == expected);
    CHECK(visibility_of(drawn::view()) == visibility_of(drawn_type::view()));
    constexpr float step = 1.01f / 255; // rounding, where sums are taken in another order
    for (const effect_view& optimised : {small::view(), fast::view()}) {
        const std::vector<float> made = visibility_of(optimised);
        for (std::size_t i = 0; i < made.size(); ++i)
            CHECK(std::abs(made[i] - expected[i]) <= step);
    }
}
