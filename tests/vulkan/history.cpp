// SPDX-License-Identifier: MIT
#include <crease/vulkan/runner.hpp>

#include "little_effect.hpp"
#include "validated_device.hpp"

#include <doctest/doctest.h>

using namespace crease;

namespace {

// Adds the radius to what the frame before kept, and keeps the sum for the next; in more than one descriptor
// set.
constexpr piece add_text{"add.glsl", R"(
layout(local_size_x = 2, local_size_y = 2, local_size_x_id = 0, local_size_y_id = 1) in;
layout(set = 2, binding = 3) uniform sampler2D crease_kept;
layout(set = 1, binding = 0, rgba16f) writeonly uniform image2D crease_output;
void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (all(lessThan(at, imageSize(crease_output))))
        imageStore(crease_output, at, texelFetch(crease_kept, at, 0) + vec4(crease_radius, 0.0, 0.0, crease_bias));
}
)"};
constexpr piece keep_text{"keep.glsl", R"(
layout(local_size_x = 2, local_size_y = 2, local_size_x_id = 0, local_size_y_id = 1) in;
layout(set = 0, binding = 0) uniform sampler2D crease_input;
layout(set = 0, binding = 1, rgba16f) writeonly uniform image2D crease_output;
void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (all(lessThan(at, imageSize(crease_output))))
        imageStore(crease_output, at, texelFetch(crease_input, at, 0));
}
)"};
constexpr piece add_pieces[] = {little::version, little::block, add_text};
constexpr piece keep_pieces[] = {little::version, keep_text};
constexpr binding add_bindings[] = {{"parameters", 0, access::uniform, 0, 0},
                                    {"kept", 1, access::sample, 2, 3},
                                    {"output", 2, access::store, 1, 0}};
constexpr binding keep_bindings[] = {{"input", 2, access::sample, 0, 0}, {"output", 1, access::store, 0, 1}};
constexpr constant group[] = {{"compute", "width", 0, 2}, {"compute", "height", 1, 2}};
constexpr pass passes[] = {{.name = "add",
                            .pieces = add_pieces,
                            .vertex_pieces = {},
                            .bindings = add_bindings,
                            .constants = group,
                            .size = {}},
                           {.name = "keep",
                            .pieces = keep_pieces,
                            .vertex_pieces = {},
                            .bindings = keep_bindings,
                            .constants = group,
                            .size = {}}};
constexpr resource resources[] = {{.name = "parameters"},
                                  {.name = "kept", .texels = format::rgba16_float, .life = lifetime::history},
                                  {.name = "sum", .texels = format::rgba16_float, .life = lifetime::output}};
constexpr effect_view accumulate{
    .captures = {}, .passes = passes, .resources = resources, .features = {}, .defaults = {}};

}

TEST_CASE("a history begins at 0 and is what the frame before wrote") {
    vulkan::device& device = validated_device();
    vulkan::runner runner(device, accumulate, 7, 5);
    parameters p;
    p.radius = 0.5f;
    p.bias = 2;
    runner.run(p);
    runner.run(p);
    p.radius = 4;
    runner.run(p);
    const std::vector<float> sum = runner.download("sum");
    REQUIRE(sum.size() == 7 * 5 * 4);
    for (std::size_t i = 0; i < sum.size(); i += 4)
        CHECK((sum[i] == 5 && sum[i + 1] == 0 && sum[i + 3] == 6));
    CHECK_NOTHROW(device.check_messages());
}
