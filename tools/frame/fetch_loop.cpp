// SPDX-License-Identifier: MIT
#include "frame/fetch_loop.hpp"

#include "frame/bare_pass.hpp"
#include "frame/median_run.hpp"

namespace crease::tools {

namespace {

constexpr const char* glsl = R"glsl(#version 450
layout(local_size_x = 16, local_size_y = 16, local_size_x_id = 0, local_size_y_id = 1) in;
layout(set = 0, binding = 1) uniform sampler2D crease_depth;
layout(set = 0, binding = 2, r32f) uniform writeonly image2D crease_output;

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = imageSize(crease_output);
    if (any(greaterThanEqual(pixel, size)))
        return;
    float sum = 0.0;
    for (int i = 0; i < 8; ++i)
        for (int j = 0; j < 4; ++j) {
            vec2 texel = vec2(pixel) + 0.5 + vec2(5 * i - 20, 7 * j - 12);
            sum += textureLod(crease_depth, texel / vec2(textureSize(crease_depth, 0)), 0.0).x;
        }
    imageStore(crease_output, pixel, vec4(sum));
}
)glsl";

}

double time_fetch_loop(vulkan::device& device, const gbuffer& inputs, unsigned repeats) {
    const piece pieces[] = {{"fetch_loop.comp", glsl}};
    const resource resources[] = {{.name = "parameters", .kind = resource_kind::block},
                                  {.name = "depth", .texels = format::d32_float, .size = {.guarded = true}},
                                  {.name = "sum", .texels = format::r32_float, .life = lifetime::output}};
    const binding bindings[] = {{.name = "depth", .resource = 1, .how = access::sample, .slot = 1},
                                {.name = "output", .resource = 2, .how = access::store, .slot = 2}};
    const pass passes[] = {bare_pass(pieces, bindings)};
    vulkan::runner runner(
        device, {.passes = passes, .resources = resources, .settings = {}, .features = {}, .defaults = {}},
        inputs.depth.width, inputs.depth.height, {.guard = inputs.guard, .constants = {}, .shaders = {}});
    runner.upload("depth", inputs.device);
    return median_run(runner, repeats);
}

}
