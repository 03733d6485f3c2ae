// SPDX-License-Identifier: MIT
// A history is a pair: what this frame writes, and what the frame before wrote.
#include <crease/vulkan/runner.hpp>

#include "little_effect.hpp"
#include "sentence.hpp"
#include "sized.hpp"
#include "validated_device.hpp"

#include <doctest/doctest.h>

#include <cstring>
#include <vector>

using namespace crease;

namespace {

// Writes the radius behind the digits of the frame before; in more than one descriptor set.
constexpr piece add_text{"add.glsl", R"(
layout(local_size_x = 2, local_size_y = 2, local_size_x_id = 0, local_size_y_id = 1) in;
layout(set = 2, binding = 3) uniform sampler2D crease_kept_before;
layout(set = 1, binding = 0, rgba16f) writeonly uniform image2D crease_kept;
void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (all(lessThan(at, imageSize(crease_kept))))
        imageStore(crease_kept, at, 10.0 * texelFetch(crease_kept_before, at, 0) +
                                        vec4(crease_given.radius, 0.0, 0.0, crease_given.spread_bias));
}
)"};
constexpr piece show_text{"show.glsl", R"(
layout(local_size_x = 2, local_size_y = 2, local_size_x_id = 0, local_size_y_id = 1) in;
layout(set = 0, binding = 0) uniform sampler2D crease_kept;
layout(set = 0, binding = 1, rgba16f) writeonly uniform image2D crease_output;
void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (all(lessThan(at, imageSize(crease_output))))
        imageStore(crease_output, at, texelFetch(crease_kept, at, 0));
}
)"};
constexpr piece add_pieces[] = {little::version, little::block, add_text};
constexpr piece show_pieces[] = {little::version, show_text};
constexpr binding add_bindings[] = {{"parameters", 0, access::uniform, 0, 0},
                                    {"kept_before", 2, access::sample, 2, 3},
                                    {"kept", 1, access::store, 1, 0}};
constexpr binding show_bindings[] = {{"kept", 1, access::sample, 0, 0}, {"output", 3, access::store, 0, 1}};
constexpr constant group[] = {{"compute", "width", 0, 2}, {"compute", "height", 1, 2}};
constexpr pass passes[] = {{.name = "add",
                            .pieces = add_pieces,
                            .vertex_pieces = {},
                            .bindings = add_bindings,
                            .constants = group,
                            .size = {}},
                           {.name = "show",
                            .pieces = show_pieces,
                            .vertex_pieces = {},
                            .bindings = show_bindings,
                            .constants = group,
                            .size = {}}};
constexpr resource resources[] = {
    {.name = "parameters", .kind = resource_kind::block},
    {.name = "kept", .texels = format::rgba16_float, .life = lifetime::history},
    {.name = "kept_before", .texels = format::rgba16_float, .life = lifetime::history, .previous_of = "kept"},
    {.name = "digits", .texels = format::rgba16_float, .life = lifetime::output}};
constexpr effect_view images{.passes = passes,
                             .resources = resources,
                             .settings = little::settings,
                             .views = 2,
                             .features = {},
                             .defaults = {}};

// The same with buffers.
constexpr piece count_text{"count.glsl", R"(
layout(local_size_x = 2, local_size_y = 2, local_size_x_id = 0, local_size_y_id = 1) in;
layout(std430, set = 0, binding = 1) readonly buffer crease_kept_before_buffer { uint crease_kept_before[]; };
layout(std430, set = 0, binding = 2) buffer crease_kept_buffer { uint crease_kept[]; };
layout(std430, set = 0, binding = 3) buffer crease_digits_buffer { uint crease_digits[]; };
void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i < uint(crease_kept.length()) && gl_GlobalInvocationID.y == 0u) {
        crease_kept[i] = 10u * crease_kept_before[i] + uint(crease_given.radius);
        crease_digits[i] = crease_kept[i];
    }
}
)"};
constexpr piece count_pieces[] = {little::version, little::block, count_text};
constexpr binding count_bindings[] = {{"parameters", 0, access::uniform, 0, 0},
                                      {"kept_before", 2, access::load, 0, 1},
                                      {"kept", 1, access::store, 0, 2},
                                      {"digits", 3, access::store, 0, 3}};
constexpr extent five{.fixed_width = 5, .fixed_height = 1};
constexpr pass counting[] = {{.name = "count",
                              .pieces = count_pieces,
                              .vertex_pieces = {},
                              .bindings = count_bindings,
                              .constants = group,
                              .size = five}};
constexpr resource counted[] = {{.name = "parameters", .kind = resource_kind::block},
                                {.name = "kept",
                                 .kind = resource_kind::buffer,
                                 .element = "uint",
                                 .life = lifetime::history,
                                 .size = five},
                                {.name = "kept_before",
                                 .kind = resource_kind::buffer,
                                 .element = "uint",
                                 .life = lifetime::history,
                                 .size = five,
                                 .previous_of = "kept"},
                                {.name = "digits",
                                 .kind = resource_kind::buffer,
                                 .element = "uint",
                                 .life = lifetime::report,
                                 .size = five}};
constexpr effect_view buffers{.passes = counting,
                              .resources = counted,
                              .settings = little::settings,
                              .views = 2,
                              .features = {},
                              .defaults = {}};

}

TEST_CASE("a history begins at 0, and each of three frames reads what the one before wrote") {
    vulkan::device& device = validated_device();
    vulkan::runner runner(device, images, 7, 5);
    parameters p = sized(7, 5);
    REQUIRE(set(p, little::settings, "bias", 0.5f));
    std::vector<float> before(7 * 5 * 4, 0.0f);
    for (const auto& [radius, digits, halves] :
         {std::tuple(1.0f, 1.0f, 0.5f), {2.0f, 12.0f, 5.5f}, {3.0f, 123.0f, 55.5f}}) {
        p.radius = radius;
        runner.run(p);
        const std::vector<float> texels = runner.download("digits");
        REQUIRE(texels.size() == 7 * 5 * 4);
        CHECK(runner.download("kept") == texels);
        CHECK(runner.download("kept_before") == before);
        before = texels;
        for (std::size_t i = 0; i < texels.size(); i += 4)
            CHECK((texels[i] == digits && texels[i + 1] == 0 && texels[i + 3] == halves));
    }
    CHECK_NOTHROW(device.check_messages());
}

TEST_CASE("a history of two images swaps them, and copies nothing") {
    vulkan::runner runner(validated_device(), images, 4, 4);
    const VkImage one = runner.image_of("kept").handle(), other = runner.image_of("kept_before").handle();
    for (int frame = 0; frame < 3; ++frame) {
        runner.run(sized(4, 4));
        const bool swapped = runner.image_of("kept").handle() == other;
        CHECK(runner.image_of("kept_before").handle() == (swapped ? one : other));
        CHECK(swapped == (frame % 2 == 0));
    }
}

TEST_CASE("a history of buffers begins at 0, and each of three frames reads what the one before wrote") {
    vulkan::device& device = validated_device();
    vulkan::runner runner(device, buffers, 7, 5);
    parameters p = sized(7, 5);
    std::vector<std::byte> before(5 * 4, std::byte{0});
    for (const auto& [radius, digits] : {std::pair(1.0f, 1u), {2.0f, 12u}, {3.0f, 123u}}) {
        p.radius = radius;
        runner.run(p);
        const std::vector<std::byte> bytes = runner.download_buffer("digits");
        CHECK(runner.download_buffer("kept") == bytes);
        CHECK(runner.download_buffer("kept_before") == before);
        before = bytes;
        std::uint32_t numbers[5];
        REQUIRE(bytes.size() == sizeof numbers);
        std::memcpy(numbers, bytes.data(), sizeof numbers);
        for (std::uint32_t number : numbers)
            CHECK(number == digits);
    }
    CHECK_NOTHROW(device.check_messages());
}

TEST_CASE("a fragment pass may not draw to a history, as its render target would stay with one of the pair") {
    resource kept[std::size(little::resources)];
    std::ranges::copy(little::resources, kept);
    kept[3].life = lifetime::history;
    effect_view effect = little::effect;
    effect.resources = kept;
    CHECK(sentence_of([&] { vulkan::runner(validated_device(), effect, 4, 4); }) ==
          "pass 'spread' draws to 'visibility', a history, which only a compute pass may write");
}
