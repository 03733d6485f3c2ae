// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>
#include <crease/spirv/optimise.hpp>
#include <crease/vulkan/runner.hpp>

#include "little_effect.hpp"
#include "sentence.hpp"
#include "sized.hpp"
#include "validated_device.hpp"

#include <doctest/doctest.h>

#include <memory>
#include <span>

using namespace crease;

namespace {

/// Depths of which every texel differs from its neighbours.
std::vector<float> ramp(std::uint32_t width, std::uint32_t height) {
    std::vector<float> depth(std::size_t{width} * height);
    for (std::size_t i = 0; i < depth.size(); ++i)
        depth[i] = static_cast<float>(i * 37 % 101) / 101;
    return depth;
}

/// What the little effect makes of `depth`, worked out on the host.
std::vector<float> expected(const std::vector<float>& depth, std::uint32_t width, std::uint32_t height,
                            const parameters& p, int gain = 2) {
    std::vector<float> visibility(depth.size());
    for (std::uint32_t y = 0; y < height; ++y)
        for (std::uint32_t x = 0; x < width; ++x) {
            const float scaled = depth[y / 2 * 2 * width + x / 2 * 2] * p.radius * static_cast<float>(gain);
            visibility[y * width + x] = std::min(scaled + get(p, little::settings, "bias"), 1.0f);
        }
    return visibility;
}

double largest_difference(const std::vector<float>& a, const std::vector<float>& b) {
    REQUIRE(a.size() == b.size());
    double largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        largest = std::max(largest, std::fabs(double(a[i]) - double(b[i])));
    return largest;
}

constexpr double half_a_step = 0.5 / 255 + 1e-6; // of r8_unorm

}

TEST_CASE("a compute pass and a fragment pass, at odd sizes") {
    vulkan::device& device = validated_device();
    const vulkan::runner_options compiled{.constants = {}, .shaders = vulkan::compile(little::effect)};
    for (const auto& [width, height] : {std::pair(1u, 1u), std::pair(7u, 5u), std::pair(641u, 359u)}) {
        parameters p = sized(width, height);
        p.radius = 0.25f;
        REQUIRE(set(p, little::settings, "bias", 0.125f));
        vulkan::runner runner(device, little::effect, width, height, compiled);
        const std::vector<float> depth = ramp(width, height);
        runner.upload("depth", std::span<const float>(depth));
        for (const auto& times : runner.run(p, 3)) {
            REQUIRE(times.size() == 2);
            CHECK(times[0].pass == "scale");
            CHECK(times[1].pass == "spread");
            for (const vulkan::pass_time& time : times)
                CHECK((time.milliseconds >= 0 && time.milliseconds < 10000));
        }
        CHECK(largest_difference(runner.download("visibility"), expected(depth, width, height, p)) <=
              half_a_step);
        CHECK(runner.download("scaled").size() == std::size_t{(width + 1) / 2} * ((height + 1) / 2));
        REQUIRE(set(p, little::settings, "spread.bias", 0.5f)); // a later run reads its own parameters
        runner.run(p);
        CHECK(largest_difference(runner.download("visibility"), expected(depth, width, height, p)) <=
              half_a_step);
    }
    CHECK_NOTHROW(device.check_messages());
}

TEST_CASE("optimised shaders do the same") {
    std::vector<vulkan::pass_shaders> shaders = vulkan::compile(little::effect);
    for (vulkan::pass_shaders& each : shaders)
        each.main = spirv::optimise(each.main, spirv::goal::speed);
    vulkan::runner runner(validated_device(), little::effect, 33, 17, {.constants = {}, .shaders = shaders});
    const std::vector<float> depth = ramp(33, 17);
    runner.upload("depth", std::span<const float>(depth));
    runner.run(sized(33, 17));
    CHECK(largest_difference(runner.download("visibility"), expected(depth, 33, 17, {})) <= half_a_step);
}

TEST_CASE("constants, the workgroup's among them, can be set") {
    vulkan::runner runner(
        validated_device(), little::effect, 21, 13,
        {.constants = {{"scale.gain", 1}, {"compute.width", 3}, {"compute.height", 5}}, .shaders = {}});
    const std::vector<float> depth = ramp(21, 13);
    runner.upload("depth", std::span<const float>(depth));
    runner.run(sized(21, 13));
    CHECK(largest_difference(runner.download("visibility"), expected(depth, 21, 13, {}, 1)) <= half_a_step);
}

TEST_CASE("another image can be the input, even a larger one or a depth buffer") {
    vulkan::device& device = validated_device();
    vulkan::runner runner(device, little::effect, 5, 4);
    vulkan::image_description d{.name = "own",
                                .texels = format::d32_float,
                                .width = 9,
                                .height = 4,
                                .usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT};
    vulkan::image wide(device, d);
    const std::vector<float> depth = ramp(9, 4);
    vulkan::upload(device, wide, std::span<const float>(depth));
    runner.bind("depth", wide);
    runner.run(sized(5, 4));
    std::vector<float> cropped;
    for (std::size_t y = 0; y < 4; ++y)
        cropped.insert(cropped.end(), depth.begin() + std::ptrdiff_t(y * 9),
                       depth.begin() + std::ptrdiff_t(y * 9 + 5));
    CHECK(largest_difference(runner.download("visibility"), expected(cropped, 5, 4, {})) <= half_a_step);

    const auto refusal = [&](const vulkan::image_description& other) {
        vulkan::image image(device, other);
        return sentence_of([&] { runner.bind("depth", image); });
    };
    d.width = 4;
    CHECK(refusal(d) ==
          "the image 'own' cannot be the input 'depth': it is 4 x 4, and must be at least 5 x 4");
    d.width = 9;
    d.usage = VK_IMAGE_USAGE_TRANSFER_DST_BIT;
    CHECK(contains(refusal(d), "it was not made for sampling"));
    d.usage = VK_IMAGE_USAGE_SAMPLED_BIT;
    d.texels = format::r32_uint;
    CHECK(contains(refusal(d), "it holds r32_uint"));
}

TEST_CASE("what a runner refuses") {
    vulkan::device& device = validated_device();
    const auto said = [&](const effect_view& effect, std::uint32_t width, std::uint32_t height,
                          const vulkan::runner_options& options = {}) {
        return sentence_of([&] { vulkan::runner(device, effect, width, height, options); });
    };
    CHECK(said(little::effect, 0, 5) == "a picture of 0 x 5 texels cannot be rendered");
    CHECK(contains(said(little::effect, 1u << 20, 1), "the largest is"));
    CHECK(said(little::effect, 4, 4, {.constants = {{"scale.loss", 1}}, .shaders = {}}) ==
          "the effect has no constant 'scale.loss'; it has compute.width, compute.height, scale.gain");
    CHECK(said(little::effect, 4, 4, {.constants = {}, .shaders = {{}}}) ==
          "the effect has 2 passes, but shaders for 1 were given");

    constexpr binding loop[] = {{"input", 3, access::sample, 0, 1}, {"output", 3, access::attachment}};
    pass both = little::spread;
    both.bindings = loop;
    const pass passes[] = {little::scale, both};
    effect_view wrong = little::effect;
    wrong.passes = passes;
    CHECK(said(wrong, 4, 4) == "pass 'spread' both reads and writes 'visibility'");
    both = little::spread;
    both.size = {2};
    const pass smaller[] = {little::scale, both};
    wrong.passes = smaller;
    CHECK(said(wrong, 4, 4) ==
          "pass 'spread' runs at another size than that of 'visibility', which it writes");

    vulkan::runner runner(device, little::effect, 4, 4);
    CHECK(sentence_of([&] { runner.run({}); }) == "the input 'depth' was neither uploaded nor bound");
    const std::vector<float> few(15);
    CHECK(sentence_of([&] { runner.upload("depth", std::span<const float>(few)); }) ==
          "the image 'depth' takes 16 numbers, not 15");
    CHECK(sentence_of([&] { runner.upload("normals", std::span<const float>(few)); }) ==
          "there is no input named 'normals'; there is 'depth'");
    CHECK(sentence_of([&] { runner.download("normals"); }) == "there is no image named 'normals'");
    CHECK_NOTHROW(device.check_messages());
}

TEST_CASE("a view of another size than the runner's is refused") {
    vulkan::runner runner(validated_device(), little::effect, 6, 5);
    runner.upload("depth", std::vector<float>(30, 0.5f));
    for (const parameters& other : {parameters{}, sized(5, 6), sized(6, 5, 1)}) {
        const std::string sentence = sentence_of([&] { runner.run(other); });
        CAPTURE(sentence);
        CHECK(sentence.ends_with(", the runner of 6 x 5 with 0; set_projection fills it"));
    }
    CHECK_NOTHROW(runner.run(sized(6, 5)));
}

TEST_CASE("each run reads the images that were bound or uploaded last") {
    vulkan::device& device = validated_device();
    vulkan::runner runner(device, little::effect, 6, 5);
    const auto own = [&](format texels, std::uint32_t width, float depth) {
        auto made = std::make_unique<vulkan::image>(
            device,
            vulkan::image_description{.name = "own",
                                      .texels = texels,
                                      .width = width,
                                      .height = 5,
                                      .usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT});
        const std::vector<float> numbers(std::size_t{width} * 5, depth);
        vulkan::upload(device, *made, std::span<const float>(numbers));
        return made;
    };
    parameters p = sized(6, 5);
    p.radius = 0.5f; // with a gain of 2 the visibility is the depth
    const auto sees = [&](float depth) {
        runner.run(p);
        return largest_difference(runner.download("visibility"), std::vector<float>(30, depth)) <=
               half_a_step;
    };
    const auto first = own(format::r32_float, 6, 0.25f), second = own(format::d32_float, 9, 0.75f);
    runner.bind("depth", *first);
    CHECK(sees(0.25f));
    runner.bind("depth", *second);
    CHECK(sees(0.75f));
    CHECK(sees(0.75f));
    const std::vector<float> numbers(30, 0.5f);
    runner.upload("depth", std::span<const float>(numbers));
    CHECK(sees(0.5f));
    runner.bind("depth", *first);
    CHECK(sees(0.25f));
    const std::vector<float> later(30, 1.0f);
    vulkan::upload(device, *first, std::span<const float>(later)); // while it is bound
    CHECK(sees(1));
    CHECK_NOTHROW(device.check_messages());
}

TEST_CASE("what one runner writes another reads, in turns") {
    vulkan::device& device = validated_device();
    vulkan::runner first(device, little::effect, 8, 8), second(device, little::effect, 8, 8);
    second.bind("depth", first.image_of("visibility"));
    parameters p = sized(8, 8);
    p.radius = 0.25f; // with a gain of 2 the visibility is half the depth
    for (float depth : {1.0f, 0.5f}) {
        const std::vector<float> numbers(64, depth);
        first.upload("depth", std::span<const float>(numbers));
        first.run(p);
        second.run(p);
        CHECK(largest_difference(second.download("visibility"), std::vector<float>(64, depth / 4)) <=
              2 * half_a_step);
    }
    CHECK_NOTHROW(device.check_messages());
}

TEST_CASE("an effect that needs what the device lacks is refused by the name of that") {
    vulkan::device& device = validated_device();
    effect_view wanting = little::effect;
    wanting.features.depth_samples = 64; // of no device that there is
    CHECK(sentence_of([&] { vulkan::runner(device, wanting, 4, 4); }) ==
          "the device '" + device.name() +
              "' lacks depth images of 64 samples a texel, which the effect requires");
}
