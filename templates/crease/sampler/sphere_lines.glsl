// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// Lines through the sphere around the receiver.
int crease_step_count() { return crease_sphere_lines_count; }

vec3 crease_line_chord(vec2 chord, vec2 over) { return vec3(chord, (chord.y - chord.x) - (over.y - over.x)); }
#ifdef __cplusplus
")glsl"
#endif
