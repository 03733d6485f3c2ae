// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// Lines through the hemisphere over the receiver's tangent plane.
int crease_step_count() { return crease_hemisphere_lines_count; }

vec3 crease_line_chord(vec2 chord, vec2 over) { return vec3(over, 0.0); }
#ifdef __cplusplus
")glsl"
#endif
