// SPDX-License-Identifier: MIT
#pragma once

#include <crease/effect/pass.hpp>

#include <string>
#include <string_view>

/// An effect made by hand: a compute pass at half the resolution, and a fragment pass that reads what it
/// wrote.
namespace little {

using namespace crease;

inline constexpr std::string_view block_text = R"(
struct crease_view_parameters {
    vec4 from_texel;
    vec2 depth_unpack;
    float far_depth;
    float guard;
    vec2 resolution;
    vec2 texel_size;
};

layout(std140, set = 0, binding = 0) uniform crease_parameters {
    crease_view_parameters views[2];
    mat4 from_first[1];
    float radius;
    uint frame;
    float spread_bias;
    float spread_slope;
    float strength;
} crease_given;
)";

inline constexpr piece version{"version", "#version 450\n"};
inline constexpr piece block{"block.glsl", block_text};

inline constexpr piece scale_interface{"interface", R"(
layout(local_size_x = 8, local_size_y = 4, local_size_x_id = 0, local_size_y_id = 1) in;
layout(constant_id = 2) const int crease_scale_gain = 2;
layout(set = 0, binding = 1) uniform sampler2D crease_depth;
layout(set = 0, binding = 2, r32f) writeonly uniform image2D crease_output;
)"};
inline constexpr piece scale_body{"scale.glsl", R"(
void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, imageSize(crease_output))))
        return;
    float depth = texelFetch(crease_depth, 2 * at, 0).r;
    imageStore(crease_output, at, vec4(depth * crease_given.radius * float(crease_scale_gain)));
}
)"};
inline constexpr piece scale_pieces[] = {version, block, scale_interface, scale_body};
inline constexpr binding scale_bindings[] = {
    {"parameters", 0, access::uniform, 0, 0},
    {"depth", 1, access::sample, 0, 1},
    {"output", 2, access::store, 0, 2},
};
inline constexpr constant scale_constants[] = {
    {"compute", "width", 0, 8}, {"compute", "height", 1, 4}, {"scale", "gain", 2, 2}};

inline constexpr piece triangle{"triangle.glsl", R"(
void main() {
    gl_Position = vec4(gl_VertexIndex == 1 ? 3.0 : -1.0, gl_VertexIndex == 2 ? 3.0 : -1.0, 0.0, 1.0);
}
)"};
inline constexpr piece vertex_pieces[] = {version, triangle};
inline constexpr piece spread_body{"spread.glsl", R"(
layout(set = 0, binding = 1) uniform sampler2D crease_input;
layout(location = 0) out float crease_output;
void main() { crease_output = texelFetch(crease_input, ivec2(gl_FragCoord.xy) / 2, 0).r + crease_given.spread_bias; }
)"};
inline constexpr piece spread_pieces[] = {version, block, spread_body};
inline constexpr binding spread_bindings[] = {
    {"parameters", 0, access::uniform, 0, 0},
    {"input", 2, access::sample, 0, 1},
    {"output", 3, access::attachment},
};

inline constexpr resource resources[] = {
    {.name = "parameters", .kind = resource_kind::block},
    {.name = "depth", .texels = format::r32_float, .life = lifetime::input},
    {.name = "scaled", .texels = format::r32_float, .life = lifetime::transient, .size = {2}},
    {.name = "visibility", .texels = format::r8_unorm, .life = lifetime::output},
};

inline constexpr pass scale{.name = "scale",
                            .stage = stage_kind::compute,
                            .pieces = scale_pieces,
                            .vertex_pieces = {},
                            .bindings = scale_bindings,
                            .constants = scale_constants,
                            .size = {2}};
inline constexpr pass spread{.name = "spread",
                             .stage = stage_kind::fragment,
                             .pieces = spread_pieces,
                             .vertex_pieces = vertex_pieces,
                             .bindings = spread_bindings,
                             .constants = {},
                             .size = {1}};
inline constexpr pass passes[] = {scale, spread};

inline constexpr effect_setting settings[] = {
    {"spread", "bias", 0, 0, 1, "", false},
    {"spread", "slope", 0, 0, 1, "", false},
    {"scale", "strength", 1, 0, 1, "", true},
};

inline constexpr effect_view effect{.passes = passes,
                                    .resources = resources,
                                    .settings = settings,
                                    .views = 2,
                                    .features = {},
                                    .defaults = {}};

}
