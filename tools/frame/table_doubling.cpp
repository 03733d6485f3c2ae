// SPDX-License-Identifier: MIT
#include "frame/table_doubling.hpp"

#include "frame/bare_pass.hpp"
#include "frame/median_run.hpp"

#include <array>
#include <bit>

namespace crease::tools {

namespace {

constexpr const char* glsl = R"glsl(#version 450
layout(local_size_x = 16, local_size_y = 16, local_size_x_id = 0, local_size_y_id = 1) in;
layout(constant_id = 2) const int crease_right = 0;
layout(constant_id = 3) const int crease_down = 0;
layout(set = 0, binding = 1, rgba32f) uniform image2D crease_from;
layout(set = 0, binding = 2, rgba32f) uniform writeonly image2D crease_output;

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(texel, imageSize(crease_output))))
        return;
    vec4 sum = imageLoad(crease_from, texel);
    ivec2 before = texel - ivec2(crease_right, crease_down);
    if (all(greaterThanEqual(before, ivec2(0))))
        sum += imageLoad(crease_from, before);
    imageStore(crease_output, texel, sum);
}
)glsl";

}

double time_table_doubling(vulkan::device& device, unsigned width, unsigned height, unsigned repeats) {
    const piece pieces[] = {{"table_doubling.comp", glsl}};
    const resource resources[] = {
        {.name = "parameters", .kind = resource_kind::block},
        {.name = "even", .texels = format::rgba32_float, .life = lifetime::transient},
        {.name = "odd", .texels = format::rgba32_float, .life = lifetime::transient}};
    const binding there[] = {{.name = "from", .resource = 1, .how = access::modify, .slot = 1},
                             {.name = "output", .resource = 2, .how = access::store, .slot = 2}};
    const binding back[] = {{.name = "from", .resource = 2, .how = access::modify, .slot = 1},
                            {.name = "output", .resource = 1, .how = access::store, .slot = 2}};
    const int rows = static_cast<int>(std::bit_width(width - 1)),
              columns = static_cast<int>(std::bit_width(height - 1));
    std::vector<std::array<constant, 4>> constants;
    for (int i = 0; i < rows + columns; ++i)
        constants.push_back({{{"compute", "width", 0, 16},
                              {"compute", "height", 1, 16},
                              {"", "right", 2, i < rows ? 1 << i : 0},
                              {"", "down", 3, i < rows ? 0 : 1 << (i - rows)}}});
    std::vector<pass> passes;
    for (const std::array<constant, 4>& own : constants)
        passes.push_back(
            bare_pass(pieces, passes.size() % 2 == 0 ? array_view<const binding>(there) : back, own));
    vulkan::runner runner(
        device, {.passes = passes, .resources = resources, .settings = {}, .features = {}, .defaults = {}},
        width, height);
    return median_run(runner, repeats);
}

}
