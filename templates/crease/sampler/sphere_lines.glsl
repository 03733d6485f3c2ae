#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// Lines through the sphere around the receiver.

int crease_step_count() { return crease_sphere_lines_count; }

float crease_volume_behind() { return 0.5; }

void crease_line_clip(crease_receiver receiver, vec3 start, vec3 ray, inout vec2 chord) {}
#ifdef __cplusplus
")glsl"
#endif
