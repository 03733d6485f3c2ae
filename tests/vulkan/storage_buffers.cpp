// SPDX-License-Identifier: MIT
// Buffers that passes write: counters for the host, cleared before each frame, and lists for later passes.
#include <crease/vulkan/runner.hpp>

#include "little_effect.hpp"
#include "recorded_barriers.hpp"
#include "sentence.hpp"
#include "sized.hpp"
#include "validated_device.hpp"

#include <doctest/doctest.h>

#include <cstring>
#include <vector>

using namespace crease;

namespace {

// Counts the texels that are nearer than the radius, keeps the least depth, and lists all depths.
constexpr piece count_text{"count.glsl", R"(
layout(local_size_x = 4, local_size_y = 4, local_size_x_id = 0, local_size_y_id = 1) in;
layout(set = 0, binding = 1) uniform sampler2D crease_depth;
layout(std430, set = 0, binding = 2) buffer crease_counter_buffer { uint crease_counter[]; };
layout(std430, set = 0, binding = 3) buffer crease_least_buffer { uint crease_least[]; };
layout(std430, set = 0, binding = 4) buffer crease_list_buffer { vec2 crease_list[]; };
void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy), size = textureSize(crease_depth, 0);
    if (any(greaterThanEqual(at, size)))
        return;
    float depth = texelFetch(crease_depth, at, 0).x;
    if (depth < crease_given.radius)
        atomicAdd(crease_counter[1], 1u);
    atomicMin(crease_least[0], floatBitsToUint(depth));
    for (int i = 0; i < 3; ++i)
        crease_list[3 * (at.y * size.x + at.x) + i] = vec2(depth, float(i));
}
)"};
// A fragment pass reads what the compute pass wrote.
constexpr piece show_text{"show.glsl", R"(
layout(std430, set = 0, binding = 0) readonly buffer crease_list_buffer { vec2 crease_list[]; };
layout(location = 0) out vec4 crease_output;
void main() {
    vec2 last = crease_list[3 * (int(gl_FragCoord.y) * 9 + int(gl_FragCoord.x)) + 2];
    crease_output = vec4(last.x + last.y);
}
)"};
constexpr piece count_pieces[] = {little::version, little::block, count_text};
constexpr piece show_pieces[] = {little::version, show_text};
constexpr binding count_bindings[] = {{"parameters", 0, access::uniform, 0, 0},
                                      {"depth", 1, access::sample, 0, 1},
                                      {"counter", 2, access::modify, 0, 2},
                                      {"least", 3, access::modify, 0, 3},
                                      {"list", 4, access::store, 0, 4}};
constexpr binding show_bindings[] = {{"list", 4, access::load, 0, 0}, {"output", 5, access::attachment}};
constexpr constant group[] = {{"compute", "width", 0, 4}, {"compute", "height", 1, 4}};
constexpr pass passes[] = {{.name = "count",
                            .pieces = count_pieces,
                            .vertex_pieces = {},
                            .bindings = count_bindings,
                            .constants = group,
                            .size = {}},
                           {.name = "show",
                            .stage = stage_kind::fragment,
                            .pieces = show_pieces,
                            .vertex_pieces = little::vertex_pieces,
                            .bindings = show_bindings,
                            .constants = {},
                            .size = {}}};
constexpr resource resources[] = {
    {.name = "parameters", .kind = resource_kind::block},
    {.name = "depth", .texels = format::r32_float, .life = lifetime::input},
    {.name = "counter",
     .kind = resource_kind::buffer,
     .element = "uint",
     .life = lifetime::report,
     .size = {.fixed_width = 2, .fixed_height = 1},
     .cleared = true},
    {.name = "least",
     .kind = resource_kind::buffer,
     .element = "uint",
     .life = lifetime::report,
     .size = {.fixed_width = 3, .fixed_height = 1},
     .cleared = true,
     .clear = 0x7f800000u},
    {.name = "list",
     .kind = resource_kind::buffer,
     .element = "vec2",
     .life = lifetime::transient,
     .layers = 3},
    {.name = "visibility", .texels = format::r32_float, .life = lifetime::output},
};
constexpr effect_view counted{.passes = passes,
                              .resources = resources,
                              .settings = little::settings,
                              .views = 2,
                              .features = {},
                              .defaults = {}};

std::vector<std::uint32_t> numbers_in(vulkan::runner& runner, std::string_view name) {
    const std::vector<std::byte> bytes = runner.download_buffer(name);
    std::vector<std::uint32_t> numbers(bytes.size() / 4);
    std::memcpy(numbers.data(), bytes.data(), bytes.size());
    return numbers;
}

/// What a runner says of the effect with another buffer in the place of `counter`.
std::string said_with(const resource& counter) {
    resource other[std::size(resources)];
    std::ranges::copy(resources, other);
    other[2] = counter;
    effect_view effect = counted;
    effect.resources = other;
    return sentence_of([&] { vulkan::runner(validated_device(), effect, 9, 7); });
}

}

TEST_CASE("a counter is cleared before each frame, and what a report holds is read back") {
    vulkan::device& device = validated_device();
    vulkan::runner runner(device, counted, 9, 7);
    std::vector<float> depth(9 * 7);
    for (std::size_t i = 0; i < depth.size(); ++i)
        depth[i] = static_cast<float>(i + 5);
    runner.upload("depth", depth);
    parameters p = sized(9, 7);
    constexpr std::uint32_t infinite = 0x7f800000u;
    for (const std::uint32_t nearer : {20u, 20u, 0u, 63u}) {
        CAPTURE(nearer);
        p.radius = static_cast<float>(nearer + 5);
        runner.run(p);
        CHECK(numbers_in(runner, "counter") == std::vector<std::uint32_t>{0, nearer});
        CHECK(numbers_in(runner, "least") ==
              std::vector<std::uint32_t>{std::bit_cast<std::uint32_t>(5.0f), infinite, infinite});
    }
    CHECK_NOTHROW(device.check_messages());
}

TEST_CASE("a buffer of an element for each texel and layer is read by a pass of another stage") {
    vulkan::device& device = validated_device();
    vulkan::runner runner(device, counted, 9, 7);
    std::vector<float> depth(9 * 7);
    for (std::size_t i = 0; i < depth.size(); ++i)
        depth[i] = static_cast<float>(i);
    runner.upload("depth", depth);
    runner.run(sized(9, 7));
    CHECK(runner.download_buffer("list").size() == 9 * 7 * 3 * 8);
    const std::vector<float> visibility = runner.download("visibility");
    for (std::size_t i = 0; i < depth.size(); ++i)
        CHECK(visibility[i] == depth[i] + 2);
    CHECK_NOTHROW(device.check_messages());
}

TEST_CASE("what passes do with buffers waits for what was done before, and the host sees it") {
    vulkan::runner runner(validated_device(), counted, 9, 7);
    runner.upload("depth", std::vector<float>(9 * 7, 1.0f));
    const std::size_t before = recorded_barriers().size();
    runner.run(sized(9, 7));
    const std::vector<recorded_barrier> of_memory = barriers_of(VK_NULL_HANDLE, before);
    constexpr VkAccessFlags cleared = VK_ACCESS_TRANSFER_WRITE_BIT, written = VK_ACCESS_SHADER_WRITE_BIT,
                            read = VK_ACCESS_SHADER_READ_BIT;
    REQUIRE(of_memory.size() == 5); // the first two are the block's
    CHECK(of_memory[2].waits_for(VK_PIPELINE_STAGE_TRANSFER_BIT, cleared));
    CHECK(of_memory[2].is_waited_for_by(VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, read | written));
    CHECK(of_memory[3].waits_for(VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, written));
    CHECK(of_memory[3].is_waited_for_by(VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT, read));
    CHECK(of_memory[4].waits_for(VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT | VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT,
                                 written));
    CHECK(of_memory[4].is_waited_for_by(VK_PIPELINE_STAGE_HOST_BIT, VK_ACCESS_HOST_READ_BIT));
}

TEST_CASE("a buffer that is too large or of unknown elements is refused by its name") {
    vulkan::device& device = validated_device();
    resource counter = resources[2];
    CHECK(said_with(counter) == "");
    counter.size = {.fixed_width = 1u << 20, .fixed_height = 1u << 14};
    CHECK(said_with(counter) == "the device '" + device.name() + "' cannot bind the buffer 'counter' of " +
                                    std::to_string(std::uint64_t{1} << 36) + " bytes");
    counter = resources[2];
    counter.element = "mat4";
    CHECK(said_with(counter) ==
          "the buffer 'counter' is of 'mat4'; its elements may be uint, int, float, and "
          "their vectors of two or four");
    vulkan::runner runner(device, counted, 9, 7);
    CHECK(sentence_of([&] { runner.download_buffer("depth"); }) == "there is no buffer named 'depth'");
    CHECK_NOTHROW(device.check_messages());
}
