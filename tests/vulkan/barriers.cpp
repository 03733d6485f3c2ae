// SPDX-License-Identifier: MIT
// What waits for what, as the host records it.
#include <crease/vulkan/runner.hpp>

#include "little_effect.hpp"
#include "recorded_barriers.hpp"
#include "validated_device.hpp"

#include <doctest/doctest.h>

#include <span>

using namespace crease;

namespace {

constexpr VkPipelineStageFlags compute = VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT,
                               fragment = VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT;

/// A compute shader that stores `value` of what it reads at `at`.
#define TWO_READERS_COMPUTE(reads, value)                                                                    \
    "layout(local_size_x = 8, local_size_y = 8, local_size_x_id = 0, local_size_y_id = 1) in;\n" reads       \
    "layout(set = 0, binding = 2, r32f) writeonly uniform image2D crease_output;\n"                          \
    "void main() {\n"                                                                                        \
    "    ivec2 at = ivec2(gl_GlobalInvocationID.xy);\n"                                                      \
    "    if (all(lessThan(at, imageSize(crease_output))))\n"                                                 \
    "        imageStore(crease_output, at, vec4(" value "));\n"                                              \
    "}\n"
#define READ_OF(name, slot) "layout(set = 0, binding = " #slot ") uniform sampler2D crease_" #name ";\n"

constexpr piece copied[] = {
    little::version,
    {"copy.glsl", TWO_READERS_COMPUTE(READ_OF(depth, 0), "texelFetch(crease_depth, at, 0).x")}};
constexpr piece added[] = {
    little::version,
    {"add.glsl", TWO_READERS_COMPUTE(READ_OF(shared, 0), "texelFetch(crease_shared, at, 0).x + 1.0")}};
constexpr piece doubled[] = {little::version,
                             {"double.glsl",
                              READ_OF(shared, 0) "layout(location = 0) out float crease_output;\n"
                                                 "void main() {\n"
                                                 "    crease_output = 2.0 * texelFetch(crease_shared, "
                                                 "ivec2(gl_FragCoord.xy), 0).x;\n"
                                                 "}\n"}};
constexpr piece overwritten[] = {
    little::version,
    {"overwrite.glsl", TWO_READERS_COMPUTE(READ_OF(left, 0), "4.0 * texelFetch(crease_left, at, 0).x")}};
constexpr piece summed[] = {
    little::version,
    {"sum.glsl",
     TWO_READERS_COMPUTE(READ_OF(shared, 0) READ_OF(right, 1),
                         "texelFetch(crease_shared, at, 0).x + texelFetch(crease_right, at, 0).x")}};

constexpr resource resources[] = {
    {.name = "parameters", .kind = resource_kind::block},
    {.name = "depth", .texels = format::r32_float, .life = lifetime::input},
    {.name = "shared", .texels = format::r32_float, .life = lifetime::transient},
    {.name = "left", .texels = format::r32_float, .life = lifetime::transient},
    {.name = "right", .texels = format::r32_float, .life = lifetime::transient},
    {.name = "visibility", .texels = format::r32_float, .life = lifetime::output},
};
constexpr binding copy_bindings[] = {{"depth", 1, access::sample, 0, 0}, {"output", 2, access::store, 0, 2}},
                  add_bindings[] = {{"shared", 2, access::sample, 0, 0}, {"output", 3, access::store, 0, 2}},
                  double_bindings[] = {{"shared", 2, access::sample, 0, 0},
                                       {"output", 4, access::attachment}},
                  overwrite_bindings[] = {{"left", 3, access::sample, 0, 0},
                                          {"output", 2, access::store, 0, 2}},
                  sum_bindings[] = {{"shared", 2, access::sample, 0, 0},
                                    {"right", 4, access::sample, 0, 1},
                                    {"output", 5, access::store, 0, 2}};
constexpr constant group[] = {{"compute", "width", 0, 8}, {"compute", "height", 1, 8}};

constexpr pass computed(std::string_view name, array_view<const piece> pieces,
                        array_view<const binding> bindings) {
    return {.name = name,
            .pieces = pieces,
            .vertex_pieces = {},
            .bindings = bindings,
            .constants = group,
            .size = {}};
}
constexpr pass passes[] = {computed("copy", copied, copy_bindings),
                           computed("add", added, add_bindings),
                           {.name = "double",
                            .stage = stage_kind::fragment,
                            .pieces = doubled,
                            .vertex_pieces = little::vertex_pieces,
                            .bindings = double_bindings,
                            .constants = {},
                            .size = {}},
                           computed("overwrite", overwritten, overwrite_bindings),
                           computed("sum", summed, sum_bindings)};
/// A compute pass and a fragment pass read an image, which a third then writes.
constexpr effect_view two_readers{
    .passes = passes, .resources = resources, .settings = {}, .views = 1, .features = {}, .defaults = {}};

}

TEST_CASE("a pass that writes what passes of two stages have read waits for both, in each run") {
    vulkan::device& device = validated_device();
    vulkan::runner runner(device, two_readers, 9, 7);
    std::vector<float> depth(9 * 7);
    for (std::size_t i = 0; i < depth.size(); ++i)
        depth[i] = static_cast<float>(i);
    runner.upload("depth", std::span<const float>(depth));
    for (int run = 0; run < 2; ++run) {
        CAPTURE(run);
        const std::size_t before = recorded_barriers().size();
        runner.run({});
        const auto of_shared = barriers_of(runner.image_of("shared").handle(), before);
        REQUIRE(of_shared.size() == 5); // written, read twice, written, read
        CHECK(of_shared[1].waits_for(compute, VK_ACCESS_SHADER_WRITE_BIT));
        CHECK(of_shared[1].is_waited_for_by(compute, VK_ACCESS_SHADER_READ_BIT));
        CHECK(of_shared[2].waits_for(compute, 0));
        CHECK(of_shared[2].is_waited_for_by(fragment, VK_ACCESS_SHADER_READ_BIT));
        CHECK(of_shared[3].waits_for(compute | fragment, 0));
        CHECK(of_shared[3].is_waited_for_by(compute, VK_ACCESS_SHADER_WRITE_BIT));
        CHECK(of_shared[4].waits_for(compute, VK_ACCESS_SHADER_WRITE_BIT));
        CHECK(of_shared[4].is_waited_for_by(compute, VK_ACCESS_SHADER_READ_BIT));
        if (run == 1) // the run before read it last
            CHECK(of_shared[0].waits_for(compute, 0));
        const std::vector<float> visibility = runner.download("visibility");
        REQUIRE(visibility.size() == depth.size());
        for (std::size_t i = 0; i < depth.size(); ++i)
            CHECK(visibility[i] == 4 * (depth[i] + 1) + 2 * depth[i]);
    }
    CHECK_NOTHROW(device.check_messages());
}

TEST_CASE("what is drawn to is waited for by what samples it") {
    vulkan::device& device = validated_device();
    vulkan::runner runner(device, two_readers, 4, 4);
    const std::vector<float> depth(16, 0.5f);
    runner.upload("depth", std::span<const float>(depth));
    runner.run({});
    const auto of_right = barriers_of(runner.image_of("right").handle());
    REQUIRE(of_right.size() == 2);
    CHECK(of_right[0].is_waited_for_by(VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT,
                                       VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT));
    CHECK(of_right[0].after == VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL);
    CHECK(of_right[1].waits_for(VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT,
                                VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT));
    CHECK(of_right[1].is_waited_for_by(compute, VK_ACCESS_SHADER_READ_BIT));
    CHECK(of_right[1].after == VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
}
