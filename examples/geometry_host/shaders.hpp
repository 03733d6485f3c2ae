// SPDX-License-Identifier: MIT
#pragma once

/// The engine's geometry: a wall, a round screen in front of it, and a block on the wall that the screen
/// hides.
namespace shaders {

inline constexpr unsigned boxes = 3, vertices_of_box = 36;
inline constexpr float radius = 1; // of the ambient occlusion, in the units of the scene

inline constexpr const char* vertex = R"glsl(#version 450
const vec3 least[] = vec3[](vec3(-9.0, -9.0, -5.1), vec3(-0.7, -0.7, -3.02), vec3(-1.0, -0.3, -5.0));
const vec3 most[] = vec3[](vec3(9.0, 9.0, -5.0), vec3(0.7, 0.7, -3.0), vec3(1.0, 0.3, -4.6));

layout(push_constant) uniform camera { mat4 projection; };
layout(location = 0) out vec3 world;
layout(location = 1) flat out int box;

void main() {
    const int corners[] = int[](0, 1, 2, 2, 1, 3);
    int corner = corners[gl_VertexIndex % 6], side = gl_VertexIndex / 6;
    vec3 unit = vec3(corner & 1, corner >> 1, side & 1);
    unit = side < 2 ? unit : side < 4 ? unit.yzx : unit.zxy;
    box = gl_InstanceIndex;
    world = mix(least[box], most[box], unit);
    gl_Position = projection * vec4(world, 1.0);
}
)glsl";

/// Follows what defines crease_capture, so that one text serves all passes.
inline constexpr const char* fragment = R"glsl(
layout(location = 0) in vec3 world;
layout(location = 1) flat in int box;

void main() {
    if (box == 1 && length(world.xy) > 0.7) // the alpha test, which makes the screen round
        discard;
    crease_capture(world);
}
)glsl";

inline constexpr const char* captures_nothing = "void crease_capture(vec3 anchor) {}\n";

}
