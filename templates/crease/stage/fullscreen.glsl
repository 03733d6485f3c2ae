// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// One triangle that covers the output, from the vertex's index alone.
void main() {
    vec2 corner = vec2(CREASE_VERTEX_INDEX == 1 ? 3.0 : -1.0, CREASE_VERTEX_INDEX == 2 ? 3.0 : -1.0);
    gl_Position = vec4(corner, 0.0, 1.0);
}
#ifdef __cplusplus
")glsl"
#endif
