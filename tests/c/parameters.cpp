// SPDX-License-Identifier: MIT
#include <crease_c.h>

#include <crease/crease.hpp>

#include <doctest/doctest.h>

#include <cstring>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace {

constexpr const char* text = "directions:8x4/single_layer/hbao/bilateral";
constexpr float projection[16] = {1, 0, 0, 0, 0, -1.5f, 0, 0, 0.1f, 0, 0, -1, 0, 0, 0.1f, 0};
constexpr const char* null_argument = "crease_c: an argument is NULL";

struct owned {
    crease_composition* handle = crease_compose(text);
    const crease_effect* effect = crease_effect_of(handle);

    owned() = default;
    owned(const owned&) = delete;
    owned& operator=(const owned&) = delete;
    ~owned() { crease_destroy(handle); }
};

std::string sentence(const char* error) {
    return error ? error : "";
}

}

TEST_CASE("the uniform block is that of C++") {
    const owned c;
    REQUIRE(c.effect);
    const auto cpp = std::make_unique<crease::composition>(crease::recipe(text));
    const crease::effect_view effect = cpp->view();
    crease::parameters p = effect.defaults;
    p.radius = 0.5f;
    p.frame = 7;
    REQUIRE(crease::set(p, effect.settings, "strength", 1.25f));
    REQUIRE(crease::set(p, effect.settings, "hbao.bias", 0.25f));
    REQUIRE(crease::set_projection(p.view, projection, 640, 360, {.y_up = true}, 8));
    std::vector<std::byte> expected(effect.block_size());
    crease::write_block(p, effect.views, effect.settings.size(), expected.data());

    std::vector<std::byte> block(c.effect->block_size, std::byte{0xcd});
    REQUIRE(sentence(crease_write_defaults(c.effect, block.data(), block.size())) == "");
    REQUIRE(sentence(crease_set(c.effect, block.data(), "strength", 1.25f)) == "");
    REQUIRE(sentence(crease_set(c.effect, block.data(), "hbao.bias", 0.25f)) == "");
    crease_view view;
    REQUIRE(sentence(crease_set_projection(&view, projection, 640, 360, CREASE_CONVENTION_Y_UP, 8)) == "");
    std::memcpy(block.data(), &view, sizeof view);
    std::memcpy(block.data() + c.effect->radius_offset, &p.radius, 4);
    std::memcpy(block.data() + c.effect->frame_offset, &p.frame, 4);
    CHECK(block == expected);
}

TEST_CASE("each convention is that of C++") {
    const float other_handed[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0.1f, 0};
    const float by_rows[16] = {1, 0, 0.1f, 0, 0, -1.5f, 0, 0, 0, 0, 0, 0.1f, 0, 0, -1, 0};
    const float from_minus_one[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1.002f, -1, 0, 0, -0.2f, 0};
    const struct {
        const float* matrix;
        std::uint32_t convention;
        crease::matrix_convention cpp;
    } cases[] = {
        {projection, 0, {}},
        {projection, CREASE_CONVENTION_Y_UP, {.y_up = true}},
        {other_handed, CREASE_CONVENTION_LEFT_HANDED, {.left_handed = true}},
        {by_rows, CREASE_CONVENTION_ROW_MAJOR, {.row_major = true}},
        {from_minus_one, CREASE_CONVENTION_DEPTH_FROM_MINUS_ONE, {.depth_zero_to_one = false}},
    };
    for (const auto& each : cases) {
        CAPTURE(each.convention);
        crease_view c;
        crease::view_parameters cpp;
        REQUIRE(crease::set_projection(cpp, each.matrix, 64, 32, each.cpp));
        REQUIRE(sentence(crease_set_projection(&c, each.matrix, 64, 32, each.convention, 0)) == "");
        CHECK(std::memcmp(&c, &cpp, sizeof c) == 0);
    }
}

TEST_CASE("a projection that is none is refused in the sentence of C++, and the camera stays") {
    const float bad[16] = {};
    crease_view view;
    std::memset(&view, 0x5a, sizeof view);
    const crease_view before = view;
    crease::view_parameters cpp;
    CHECK(crease_set_projection(&view, bad, 64, 32, 0, 0) == crease::set_projection(cpp, bad, 64, 32).error);
    CHECK(crease_set_projection(&view, projection, 0, 32, 0, 0) ==
          crease::set_projection(cpp, projection, 0, 32).error);
    CHECK(sentence(crease_set_projection(nullptr, projection, 1, 1, 0, 0)) == null_argument);
    CHECK(sentence(crease_set_projection(&view, nullptr, 1, 1, 0, 0)) == null_argument);
    CHECK(std::memcmp(&view, &before, sizeof view) == 0);
}

TEST_CASE("what a setting cannot be is refused, and the block stays") {
    const owned c;
    std::vector<std::byte> block(c.effect->block_size);
    REQUIRE(sentence(crease_write_defaults(c.effect, block.data(), block.size())) == "");
    const std::vector<std::byte> before = block;
    CHECK(sentence(crease_set(c.effect, block.data(), "nobody", 1)) ==
          "crease_c: the effect has no setting of that name: see crease_effect::settings");
    for (float value : {-1.f, 1e9f, std::numeric_limits<float>::quiet_NaN()})
        CHECK(sentence(crease_set(c.effect, block.data(), "strength", value)) ==
              "crease_c: the value is out of the range of the setting, crease_setting::least to most");
    CHECK(sentence(crease_set(nullptr, block.data(), "strength", 1)) == null_argument);
    CHECK(sentence(crease_set(c.effect, nullptr, "strength", 1)) == null_argument);
    CHECK(sentence(crease_set(c.effect, block.data(), nullptr, 1)) == null_argument);
    CHECK(sentence(crease_write_defaults(nullptr, block.data(), block.size())) == null_argument);
    CHECK(sentence(crease_write_defaults(c.effect, nullptr, block.size())) == null_argument);
    CHECK(sentence(crease_write_defaults(c.effect, block.data(), block.size() - 1)) ==
          "crease_c: the block has fewer bytes than crease_effect::block_size");
    CHECK(block == before);
}

TEST_CASE("a guard band widens the projection as in C++") {
    float c[16], cpp[16];
    std::memcpy(c, projection, sizeof c);
    std::memcpy(cpp, projection, sizeof cpp);
    crease::widen_projection(cpp, 640, 360, 20);
    CHECK(sentence(crease_widen_projection(c, 640, 360, 20)) == "");
    CHECK(std::memcmp(c, cpp, sizeof c) == 0);
    CHECK(sentence(crease_widen_projection(nullptr, 640, 360, 20)) == null_argument);
}

TEST_CASE("sides of images") {
    const crease_extent half{2, 1, 0, 0, 0}, fixed{1, 0, 64, 32, 1}, broken{};
    CHECK(crease_width_of(&half, 641, 10) == 341);
    CHECK(crease_height_of(&half, 361, 0) == 181);
    CHECK(crease_width_of(&fixed, 641, 10) == 32);
    CHECK(crease_height_of(&fixed, 361, 10) == 16);
    CHECK(crease_width_of(nullptr, 641, 10) == 0);
    CHECK(crease_height_of(nullptr, 641, 10) == 0);
    CHECK(crease_width_of(&broken, 641, 10) == 0);
}
