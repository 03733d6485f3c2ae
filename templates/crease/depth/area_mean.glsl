#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// The position that stands for the mean of what a sum over a table holds.

float crease_range_mean();
vec3 crease_area_position(vec3 value, float centre);

vec3 crease_area_mean(vec4 sum) { return crease_area_position(sum.xzw / sum.y, crease_range_mean()); }
#ifdef __cplusplus
")glsl"
#endif
