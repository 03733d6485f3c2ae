// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>
#include <crease/vulkan/capturer.hpp>

#include "sentence.hpp"
#include "small_corner.hpp"
#include "validated_device.hpp"

#include <doctest/doctest.h>

#include <bit>
#include <memory>
#include <span>
#include <string>

using namespace crease;

namespace {

constexpr piece vertex[] = {{"test.vert", R"(#version 450
layout(location = 0) in vec3 position;
layout(location = 0) out vec3 anchor;
void main() {
    anchor = position;
    gl_Position = vec4(position, 1.0);
}
)"}};
constexpr piece captures[] = {{"test.frag", R"(
layout(location = 0) in vec3 anchor;
void main() { crease_capture(anchor); }
)"}};

std::unique_ptr<composition> composed(const std::string& recipe_text) {
    const recipe chosen{std::string_view(recipe_text)};
    REQUIRE_MESSAGE(static_cast<bool>(chosen), chosen.error());
    return std::make_unique<composition>(chosen);
}

/// A triangle at this device depth over the part of the picture that is left of `right`.
std::vector<float> triangle(float right, float depth) {
    std::vector<float> all;
    for (const auto& [x, y] : {std::pair(right, -9.0f), {right, 9.0f}, {right - 18, 0.0f}})
        all.insert(all.end(), {x, y, depth, 0, 0, 1});
    return all;
}

constexpr unsigned side = 8;

parameters seen_from_the_eye(const effect_view& effect) {
    parameters values = effect.defaults;
    set_projection(values.view, small_corner::projection, side, side); // the depth is 0.1 / device depth
    values.opacity = 1;
    return values;
}

}

TEST_CASE("an array of one layer keeps the nearest, whatever comes first, and is cleared before each draw") {
    vulkan::device& device = validated_device();
    const auto effect = composed("directions:4x4/stochastic_layers:1/hbao/atomic_minimum");
    vulkan::runner runner(device, effect->view(), side, side);
    vulkan::capturer capturer(device, effect->view(), 0, runner, {.vertex = vertex, .fragment = captures});
    const parameters values = seen_from_the_eye(effect->view());
    const auto kept = [&](const std::vector<float>& triangles) {
        capturer.draw(vulkan::mesh(device, triangles), values);
        return runner.download_uint("captured_layers");
    };
    std::vector<float> both = triangle(9, 0.02f); // depth 5, over all
    const std::vector<float> nearer = triangle(0, 0.05f);
    both.insert(both.end(), nearer.begin(), nearer.end());
    const std::vector<std::uint32_t> of_both = kept(both);
    REQUIRE(of_both.size() == side * side); // one layer
    for (std::size_t i = 0; i < of_both.size(); ++i) {
        const float depth = std::bit_cast<float>(of_both[i]), expected = i % side < side / 2 ? 2.0f : 5.0f;
        CHECK(std::abs(depth - expected) < 1e-5f * expected);
    }
    const std::vector<std::uint32_t> of_one = kept(nearer);
    for (std::size_t i = 0; i < of_one.size(); ++i)
        CHECK((of_one[i] == ~0u) == (i % side >= side / 2));
    CHECK_NOTHROW(device.check_messages());
}

TEST_CASE("one sample packs into one component, if it is not before the front; behind it alone where a fold "
          "looks there") {
    vulkan::device& device = validated_device();
    const std::vector<float> captured{1, 2, 3};
    for (const bool front_is_kept : {true, false}) {
        const std::string fold = front_is_kept ? "all_layers" : "front_first";
        CAPTURE(fold);
        const auto effect = composed(std::string("directions:4x4/stochastic_layers:1/hbao/atomic_minimum/"
                                                 "reconstructed_normals/linear_depth/") +
                                     fold);
        vulkan::runner runner(device, effect->view(), 3, 1);
        runner.upload("depth", std::vector<float>(3, 2.0f));
        std::vector<std::uint32_t> bits;
        for (float depth : captured)
            bits.push_back(std::bit_cast<std::uint32_t>(depth));
        vulkan::upload(device, runner.image_of("captured_layers"), std::span<const std::uint32_t>(bits));
        runner.run(seen_from_the_eye(effect->view()));
        const std::vector<float> packed = runner.download("packed_layers");
        REQUIRE(packed.size() == 3);
        CHECK(packed[0] > 1e6f); // there is none
        CHECK((front_is_kept ? packed[1] == 2 : packed[1] > 1e6f));
        CHECK(packed[2] == 3);
    }
    CHECK_NOTHROW(device.check_messages());
}

TEST_CASE("where the device has no depth images of so many samples, that is said and nothing is run") {
    vulkan::device& device = validated_device();
    for (unsigned samples : {1u, 3u, 6u, 12u, 32u}) { // of images of 2, 4, 8, 16 and 32 samples
        CAPTURE(samples);
        const unsigned images = std::bit_ceil(std::max(samples, 2u));
        const auto effect =
            composed("directions:4x4/stochastic_layers:" + std::to_string(samples) + "/hbao/multisampled");
        const std::string said = sentence_of([&] { vulkan::runner(device, effect->view(), side, side); });
        if (device.features().depth_samples & images) {
            CHECK(said == "");
            continue;
        }
        MESSAGE("the device lacks depth images of " << images << " samples: multisampled is refused on it");
        CHECK(said == "the device '" + device.name() + "' lacks depth images of " + std::to_string(images) +
                          " samples a texel, which the effect requires");
    }
    CHECK_NOTHROW(device.check_messages());
}

TEST_CASE("samples of an image keep the nearest of what covers them") {
    vulkan::device& device = validated_device();
    if (!(device.features().depth_samples & 4)) {
        MESSAGE("the device lacks depth images of 4 samples: multisampled is not drawn on it");
        return;
    }
    const auto effect =
        composed("directions:4x4/stochastic_layers:4/hbao/multisampled/reconstructed_normals/linear_depth");
    vulkan::runner runner(device, effect->view(), side, side);
    vulkan::capturer capturer(device, effect->view(), 0, runner,
                              {.vertex = vertex, .fragment = captures, .reversed_depth = true});
    std::vector<float> both = triangle(9, 0.02f); // depth 5, over all
    const std::vector<float> nearer = triangle(0, 0.05f);
    both.insert(both.end(), nearer.begin(), nearer.end());
    const parameters values = seen_from_the_eye(effect->view());
    capturer.draw(vulkan::mesh(device, both), values);
    runner.upload("depth", std::vector<float>(side * side, 1.0f));
    runner.run(values);
    const std::vector<float> packed = runner.download("packed_layers");
    REQUIRE(packed.size() == side * side * 4);
    for (std::size_t i = 0; i < side * side; ++i) {
        const float expected = i % side < side / 2 ? 2.0f : 5.0f;
        CHECK(std::abs(packed[4 * i] - expected) < 1e-5f * expected);
        CHECK(packed[4 * i + 1] > 1e6f); // all four samples hold the same
    }
    CHECK_NOTHROW(device.check_messages());
}
