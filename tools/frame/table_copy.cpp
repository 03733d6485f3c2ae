// SPDX-License-Identifier: MIT
#include "frame/table_copy.hpp"

#include "frame/bare_pass.hpp"
#include "frame/median_run.hpp"

namespace crease::tools {

namespace {

constexpr const char* glsl = R"glsl(#version 450
layout(local_size_x = 16, local_size_y = 16, local_size_x_id = 0, local_size_y_id = 1) in;
layout(set = 0, binding = 1, rgba32f) uniform image2D crease_from;
layout(set = 0, binding = 2, rgba32f) uniform writeonly image2D crease_output;

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    if (all(lessThan(texel, imageSize(crease_output))))
        imageStore(crease_output, texel, imageLoad(crease_from, texel));
}
)glsl";

}

double time_table_copy(vulkan::device& device, unsigned width, unsigned height, unsigned repeats) {
    const piece pieces[] = {{"table_copy.comp", glsl}};
    const resource resources[] = {
        {.name = "parameters", .kind = resource_kind::block},
        {.name = "from", .texels = format::rgba32_float, .life = lifetime::transient},
        {.name = "to", .texels = format::rgba32_float, .life = lifetime::output}};
    const binding bindings[] = {{.name = "from", .resource = 1, .how = access::modify, .slot = 1},
                                {.name = "output", .resource = 2, .how = access::store, .slot = 2}};
    const pass passes[] = {bare_pass(pieces, bindings)};
    vulkan::runner runner(
        device, {.passes = passes, .resources = resources, .settings = {}, .features = {}, .defaults = {}},
        width, height);
    return median_run(runner, repeats);
}

}
