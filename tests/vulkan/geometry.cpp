// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>
#include <crease/vulkan/runner.hpp>

#include "given_layers.hpp"
#include "little_effect.hpp"
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
constexpr piece fragment[] = {{"test.frag", R"(
layout(location = 0) in vec3 anchor;
void main() { crease_capture(anchor); }
)"}};
constexpr vulkan::geometry_shaders host{.vertex = vertex, .fragment = fragment};

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

/// One over all at depth 5, and then a nearer one, at depth 2, over the left half.
std::vector<float> two_triangles() {
    std::vector<float> both = triangle(9, 0.02f);
    const std::vector<float> nearer = triangle(0, 0.05f);
    both.insert(both.end(), nearer.begin(), nearer.end());
    return both;
}

constexpr unsigned side = 8;

parameters seen_from_the_eye(const effect_view& effect, unsigned width = side, unsigned height = side) {
    parameters values = effect.defaults;
    REQUIRE(set_projection(values.view, small_corner::projection, width,
                           height)); // the depth is 0.1 / device depth
    REQUIRE(set(values, effect.settings, "opacity", 1));
    return values;
}

/// A runner whose inputs are given, so that only what it draws is missing.
std::unique_ptr<vulkan::runner> ready(const effect_view& effect) {
    auto runner = std::make_unique<vulkan::runner>(validated_device(), effect, side, side);
    runner->upload("depth", std::vector<float>(side * side, 1.0f));
    return runner;
}

// A compute pass fills an image with 10, and a geometry pass that runs twice changes each texel that it
// covers: other numbers come out where one does not wait for the other.
constexpr piece start_pieces[] = {little::version, {"start.glsl", R"(
layout(local_size_x = 8, local_size_y = 8, local_size_x_id = 0, local_size_y_id = 1) in;
layout(set = 0, binding = 0, r32ui) writeonly uniform uimage2D crease_levels;
void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (all(lessThan(at, imageSize(crease_levels))))
        imageStore(crease_levels, at, uvec4(10u));
}
)"}};
constexpr piece double_pieces[] = {{"double.glsl", R"(
layout(constant_id = 4) const int crease_double_added = 1;
layout(set = 1, binding = 2, r32ui) uniform uimage2D crease_levels;
void crease_capture(vec3 anchor) {
    ivec2 at = ivec2(gl_FragCoord.xy);
    imageStore(crease_levels, at, 2u * imageLoad(crease_levels, at) + uint(crease_double_added));
}
)"}};
constexpr binding start_bindings[] = {{"levels", 1, access::store, 0, 0}},
                  double_bindings[] = {{"levels", 1, access::modify, 1, 2}};
constexpr constant start_constants[] = {{"compute", "width", 0, 8}, {"compute", "height", 1, 8}},
                   double_constants[] = {{"double", "added", 4, 1}};
constexpr pass starts{.name = "start",
                      .pieces = start_pieces,
                      .vertex_pieces = {},
                      .bindings = start_bindings,
                      .constants = start_constants,
                      .size = {}};
constexpr pass doubles{.name = "double",
                       .stage = stage_kind::geometry,
                       .pieces = double_pieces,
                       .vertex_pieces = {},
                       .bindings = double_bindings,
                       .constants = double_constants,
                       .size = {}};
constexpr pass level_passes[] = {starts, doubles, doubles};
constexpr resource level_resources[] = {
    {.name = "parameters", .kind = resource_kind::block},
    {.name = "levels", .texels = format::r32_uint, .life = lifetime::output}};
constexpr effect_view levels{.passes = level_passes,
                             .resources = level_resources,
                             .settings = {},
                             .views = 1,
                             .features = {.fragment_stores_and_atomics = true},
                             .defaults = {}};

}

TEST_CASE("a geometry pass that follows a compute pass and runs twice does so in order, in each run") {
    vulkan::device& device = validated_device();
    const vulkan::mesh left(device, triangle(0, 0.5f)), all(device, triangle(9, 0.5f));
    const auto drawn = [&](const vulkan::mesh& triangles, const vulkan::runner_options& options) {
        vulkan::runner runner(device, levels, side, side, options);
        runner.set_geometry("double", host, triangles);
        runner.run({});
        const std::vector<vulkan::pass_time> times = runner.run({});
        REQUIRE(times.size() == 3);
        CHECK(times[0].pass == "start");
        CHECK(times[1].pass == "double");
        CHECK(times[2].pass == "double");
        return runner.download_uint("levels");
    };
    CHECK(drawn(all, {}) == std::vector<std::uint32_t>(side * side, 43));
    const std::vector<std::uint32_t> of_left = drawn(left, {});
    for (std::size_t i = 0; i < of_left.size(); ++i)
        CHECK(of_left[i] == (i % side < side / 2 ? 43 : 10));
    CHECK(drawn(all, {.constants = {{"double.added", 2}}, .shaders = {}}) ==
          std::vector<std::uint32_t>(side * side, 46));
    CHECK_NOTHROW(device.check_messages());
}

TEST_CASE("a geometry pass may have its SPIR-V from the options, and has it from there alone") {
    vulkan::device& device = validated_device();
    const vulkan::mesh all(device, triangle(9, 0.5f));
    std::vector<vulkan::pass_shaders> shaders = vulkan::compile(levels);
    CHECK(shaders[1].main.empty());
    const auto runner_with = [&] {
        return std::make_unique<vulkan::runner>(device, levels, side, side,
                                                vulkan::runner_options{.constants = {}, .shaders = shaders});
    };
    CHECK(
        sentence_of([&] { runner_with()->set_geometry("double", {}, all); }) ==
        "the geometry pass 'double' has no SPIR-V among the options of the runner: give set_geometry both a "
        "vertex and a fragment shader");
    CHECK(sentence_of([&] { runner_with()->set_geometry("double", host, all); }) == "");
    shaders[1] = shaders[2] = vulkan::compile(levels.passes[1], host);
    const auto runner = runner_with();
    CHECK(sentence_of([&] { runner->set_geometry("double", host, all); }) ==
          "the geometry pass 'double' has SPIR-V among the options of the runner: give set_geometry no GLSL "
          "for it");
    runner->set_geometry("double", {}, all);
    runner->run({});
    CHECK(runner->download_uint("levels") == std::vector<std::uint32_t>(side * side, 43));
    shaders[1].vertex.clear();
    CHECK(sentence_of(runner_with) ==
          "the shaders given for pass 'double' are not those that compile() makes "
          "of it: one is missing or too many");
    CHECK_NOTHROW(device.check_messages());
}

TEST_CASE("what a geometry pass draws may change between runs") {
    vulkan::device& device = validated_device();
    const vulkan::mesh left(device, triangle(0, 0.5f)), all(device, triangle(9, 0.5f));
    vulkan::runner runner(device, levels, side, side);
    for (const vulkan::mesh* each : {&left, &all, &left}) {
        runner.set_geometry("double", host, *each);
        runner.run({});
        CHECK(runner.download_uint("levels").back() == (each == &all ? 43 : 10));
    }
    CHECK_NOTHROW(device.check_messages());
}

TEST_CASE("what a geometry pass refuses, and that it wants geometry") {
    vulkan::device& device = validated_device();
    const auto effect =
        composed("directions:4x4/stochastic_layers:1/hbao/atomic_minimum/reconstructed_normals");
    const auto runner = ready(*effect);
    CHECK(sentence_of([&] { runner->run(seen_from_the_eye(*effect)); }) ==
          "nothing is drawn in the geometry pass 'capture_layers'; set_geometry says what is");
    const vulkan::mesh triangles(device, triangle(9, 0.5f));
    const auto said = [&](vulkan::runner& of, std::string_view pass,
                          const vulkan::geometry_shaders& by = host) {
        return sentence_of([&] { of.set_geometry(pass, by, triangles); });
    };
    CHECK(said(*runner, "capture_layer") ==
          "there is no geometry pass named 'capture_layer'; there is 'capture_layers'");
    CHECK(said(*runner, "visibility") ==
          "there is no geometry pass named 'visibility'; there is 'capture_layers'");
    vulkan::runner without(device, little::effect, side, side);
    CHECK(said(without, "spread") == "there is no geometry pass named 'spread'; there is none");
    vulkan::geometry_shaders other = host;
    other.push_constant_bytes = 16;
    CHECK(said(*runner, "capture_layers", other) ==
          "the geometry's shaders take 16 bytes of push constants, not 0");
    other = host;
    other.fragment = little::vertex_pieces;
    CHECK(contains(said(*runner, "capture_layers", other),
                   "the geometry pass 'capture_layers' does not compile:\nversion:"));
    CHECK(sentence_of([&] { runner->run(seen_from_the_eye(*effect)); }) ==
          "nothing is drawn in the geometry pass 'capture_layers'; set_geometry says what is");
    CHECK(said(*runner, "capture_layers") == "");
    CHECK(sentence_of([&] { runner->run(seen_from_the_eye(*effect)); }) == "");
    CHECK_NOTHROW(device.check_messages());
}

TEST_CASE("each camera has a geometry pass of its own, drawn at the size of what it fills") {
    vulkan::device& device = validated_device();
    const auto effect = composed(
        "directions:4x4/stochastic_layers:2/hbao_plus/atomic_minimum/second_view:2/reconstructed_normals");
    const auto runner = ready(*effect);
    parameters values = seen_from_the_eye(*effect);
    values.further_views[0].view = values.view;
    const vulkan::mesh left(device, triangle(0, 0.05f)), all(device, triangle(9, 0.05f));
    runner->set_geometry("capture_layers", host, left);
    CHECK(sentence_of([&] { runner->run(values); }) ==
          "nothing is drawn in the geometry pass 'captured_layers_1'; set_geometry says what is");
    runner->set_geometry("captured_layers_1", host, all);
    runner->run(values);
    const std::vector<std::uint32_t> first = runner->download_uint("captured_layers"),
                                     second = runner->download_uint("captured_layers_1");
    REQUIRE(first.size() == 2 * side * side); // two layers
    REQUIRE(second.size() == 2 * (side / 2) * (side / 2));
    for (std::size_t i = 0; i < first.size(); ++i)
        CHECK((first[i] == ~0u) == (i % side >= side / 2));
    for (std::uint32_t bits : second)
        CHECK(bits != ~0u);
    CHECK_NOTHROW(device.check_messages());
}

TEST_CASE("an array of one layer keeps the nearest, whatever comes first, and is cleared before each frame") {
    vulkan::device& device = validated_device();
    const auto effect =
        composed("directions:4x4/stochastic_layers:1/hbao/atomic_minimum/reconstructed_normals");
    const auto runner = ready(*effect);
    const parameters values = seen_from_the_eye(*effect);
    const auto kept = [&](const std::vector<float>& triangles) {
        const vulkan::mesh drawn(device, triangles);
        runner->set_geometry("capture_layers", host, drawn);
        runner->run(values);
        return runner->download_uint("captured_layers");
    };
    const std::vector<std::uint32_t> of_both = kept(two_triangles());
    REQUIRE(of_both.size() == side * side); // one layer
    for (std::size_t i = 0; i < of_both.size(); ++i) {
        const float depth = std::bit_cast<float>(of_both[i]), expected = i % side < side / 2 ? 2.0f : 5.0f;
        CHECK(std::abs(depth - expected) < 1e-5f * expected);
    }
    const std::vector<std::uint32_t> of_one = kept(triangle(0, 0.05f));
    for (std::size_t i = 0; i < of_one.size(); ++i)
        CHECK((of_one[i] == ~0u) == (i % side >= side / 2));
    CHECK_NOTHROW(device.check_messages());
}

TEST_CASE("one sample packs into one component, if it is not before the front; behind it alone where a "
          "traversal looks there") {
    vulkan::device& device = validated_device();
    const std::vector<float> captured{1, 2, 3};
    for (const bool front_is_kept : {true, false}) {
        const std::string traversal = front_is_kept ? "all_layers" : "front_first";
        CAPTURE(traversal);
        const auto effect = composed(std::string("directions:4x4/stochastic_layers:1/hbao/atomic_minimum/"
                                                 "reconstructed_normals/linear_depth/") +
                                     traversal);
        const given_layers given(*effect);
        vulkan::runner runner(device, given, 3, 1);
        runner.upload("depth", std::vector<float>(3, 2.0f));
        std::vector<std::uint32_t> bits;
        for (float depth : captured)
            bits.push_back(std::bit_cast<std::uint32_t>(depth));
        runner.upload("captured_layers", bits);
        runner.run(seen_from_the_eye(effect->view(), 3, 1));
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
    runner.upload("depth", std::vector<float>(side * side, 1.0f)); // linear, and before all
    vulkan::geometry_shaders reversed = host;
    reversed.reversed_depth = true;
    const vulkan::mesh drawn(device, two_triangles());
    runner.set_geometry("capture_layers", reversed, drawn);
    runner.run(seen_from_the_eye(*effect));
    const std::vector<float> packed = runner.download("packed_layers");
    REQUIRE(packed.size() == side * side * 4);
    for (std::size_t i = 0; i < side * side; ++i) {
        const float expected = i % side < side / 2 ? 2.0f : 5.0f;
        CHECK(std::abs(packed[4 * i] - expected) < 1e-5f * expected);
        CHECK(packed[4 * i + 1] > 1e6f); // all four samples hold the same
    }
    CHECK_NOTHROW(device.check_messages());
}
