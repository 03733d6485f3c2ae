// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include <doctest/doctest.h>

#include <cstring>
#include <limits>
#include <vector>

namespace {

using namespace crease;

constexpr effect_setting settings[] = {
    {"near", "bias", 0.5f, 0, 1, "", false},
    {"near", "strength", 1, 0, 4, "", true},
    {"far", "bias", 2, -1, 3, "", false},
};

constexpr parameters with(std::string_view name, float value) {
    parameters p;
    set(p, settings, name, value);
    return p;
}

static_assert(get(with("strength", 3), settings, "strength") == 3);
static_assert(with("near.bias", 0.25f).settings[0] == 0.25f && with("near.bias", 0.25f).settings[2] == 0);
static_assert(with("bias", 0.75f).settings[0] == 0.75f && with("bias", 0.75f).settings[2] == 0.75f);

constexpr std::size_t bytes_of_view = 48, bytes_of_matrix = 64;
static_assert(sizeof(view_parameters) == bytes_of_view);
static_assert(block_size(1, 0) == 64); // a view, radius and frame, up to 16
static_assert(block_size(1, 2) == 64);
static_assert(block_size(1, 3) == 80);
static_assert(block_size(2, 0) == 2 * bytes_of_view + bytes_of_matrix + 16);
static_assert(block_size(4, 24) == 4 * bytes_of_view + 3 * bytes_of_matrix + 8 + 96 + 8);
static_assert(radius_offset(1) == 48 && setting_offset(1, 0) == 56 && setting_offset(1, 3) == 68);

template <class Value>
Value at(const std::vector<std::byte>& bytes, std::size_t offset) {
    Value value;
    std::memcpy(&value, bytes.data() + offset, sizeof value);
    return value;
}

parameters numbered() {
    parameters p;
    p.view.from_texel[0] = 10;
    p.view.texel_size[1] = 11;
    for (std::size_t i = 0; i < most_further_views; ++i) {
        p.further_views[i].view.from_texel[0] = 20 + static_cast<float>(i);
        for (int k = 0; k < 16; ++k)
            p.further_views[i].from_first[k] = static_cast<float>(100 * (i + 1)) + static_cast<float>(k);
    }
    p.radius = 7;
    p.frame = 8;
    for (std::size_t i = 0; i < most_settings; ++i)
        p.settings[i] = 1000 + static_cast<float>(i);
    return p;
}

}

TEST_CASE("a setting is named by itself, or with its part") {
    CHECK(settings[0].is("bias"));
    CHECK(settings[0].is("near.bias"));
    CHECK_FALSE(settings[0].is("side.bias")); // another part of a name as long
    for (const char* other :
         {"", "near", "near.", ".bias", "bias.near", "far.bias", "near_bias", "near.bias2", "xnear.bias"}) {
        CAPTURE(other);
        CHECK_FALSE(settings[0].is(other));
    }
}

TEST_CASE("a setting that is not there or out of its range is refused, and nothing changes") {
    const parameters before = with("strength", 2);
    parameters p = before;
    CHECK_FALSE(set(p, settings, "colour", 1));
    CHECK_FALSE(set(p, settings, "strength", 4.5f));
    CHECK_FALSE(set(p, settings, "strength", -0.5f));
    CHECK_FALSE(set(p, settings, "strength", std::numeric_limits<float>::quiet_NaN()));
    CHECK_FALSE(set(p, settings, "bias", 2)); // which one of the two may not have
    CHECK_FALSE(set(p, {}, "strength", 1));
    CHECK(p == before);
    CHECK(set(p, settings, "strength", 4));
    CHECK(set(p, settings, "strength", 0));
    CHECK(get(p, settings, "colour") == 0);
    CHECK(get(p, {}, "strength") == 0);
}

TEST_CASE("the block of one camera: its view, the radius, the frame and the settings") {
    const parameters p = numbered();
    std::vector<std::byte> bytes(block_size(1, 3));
    write_block(p, 1, 3, bytes.data());
    CHECK(at<float>(bytes, 0) == 10);
    CHECK(at<float>(bytes, 44) == 11);
    CHECK(at<float>(bytes, 48) == 7);
    CHECK(at<std::uint32_t>(bytes, 52) == 8);
    for (std::size_t i = 0; i < 3; ++i)
        CHECK(at<float>(bytes, 56 + 4 * i) == 1000 + static_cast<float>(i));
    CHECK(at<std::uint32_t>(bytes, 68) == 0); // nothing more
}

TEST_CASE("the block of several cameras: their views, then the matrices of those beside the picture's") {
    const parameters p = numbered();
    for (std::size_t views = 2; views <= 1 + most_further_views; ++views) {
        CAPTURE(views);
        std::vector<std::byte> bytes(block_size(views, most_settings));
        write_block(p, views, most_settings, bytes.data());
        CHECK(at<float>(bytes, 0) == 10);
        for (std::size_t i = 1; i < views; ++i) {
            CHECK(at<float>(bytes, bytes_of_view * i) == 20 + static_cast<float>(i - 1));
            for (std::size_t k = 0; k < 16; ++k)
                CHECK(at<float>(bytes, bytes_of_view * views + bytes_of_matrix * (i - 1) + 4 * k) ==
                      static_cast<float>(100 * i + k));
        }
        const std::size_t after = bytes_of_view * views + bytes_of_matrix * (views - 1);
        CHECK(radius_offset(views) == after);
        CHECK(setting_offset(views, most_settings - 1) == after + 8 + 4 * (most_settings - 1));
        CHECK(at<float>(bytes, after) == 7);
        CHECK(at<std::uint32_t>(bytes, after + 4) == 8);
        CHECK(at<float>(bytes, after + 8 + 4 * (most_settings - 1)) ==
              1000 + static_cast<float>(most_settings - 1));
    }
}

namespace {

struct sharp_noise { // with a setting of the name that bilateral's has
    static constexpr setting reads[] = {{"sharpness", 1, 0, 10, ""}};
    static constexpr part description{.kind = role::noise,
                                      .name = "sharp_noise",
                                      .summary = "",
                                      .source = "",
                                      .files = hashed_noise::files,
                                      .settings = reads};
};

}

TEST_CASE("an effect sets its settings by name and writes its block") {
    using ao = effect<directions<>, single_layer, hbao, sharp_noise, bilateral<>>;
    parameters p = ao::defaults;
    CHECK(ao::set<"strength">(p, 2));
    CHECK(ao::set<"hbao.bias">(p, 0.125f));
    CHECK(ao::set<"sharp_noise.sharpness">(p, 5));
    CHECK_FALSE(ao::set<"strength">(p, -1));
    CHECK(get(p, ao::settings, "strength") == 2);
    CHECK(get(p, ao::settings, "bias") == 0.125f);
    CHECK(get(p, ao::settings, "bilateral.sharpness") == bilateral_part::reads[0].fallback);
    CHECK(get(p, ao::settings, "sharp_noise.sharpness") == 5);
    CHECK(ao::set<"sharpness">(p, 6)); // both
    CHECK(get(p, ao::settings, "bilateral.sharpness") == 6);
    CHECK(get(p, ao::settings, "sharp_noise.sharpness") == 6);

    const auto block = ao::block(p);
    CHECK(block.size() == ao::view().block_size());
    CHECK(block.size() == block_size(1, ao::settings.size()));
    const std::vector<std::byte> bytes(block.begin(), block.end());
    for (std::size_t i = 0; i < ao::settings.size(); ++i)
        CHECK(at<float>(bytes, 56 + 4 * i) == p.settings[i]);
    CHECK(effect<directions<>, stochastic_layers<>, hbao_plus, second_view<>>::view().views == 2);
}
