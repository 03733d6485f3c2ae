#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// The mean position of what a sum over a table holds.

float crease_range_mean();

vec3 crease_area_mean(vec4 sum) { return sum.xyz / sum.w - vec3(0.0, 0.0, crease_range_mean()); }
#ifdef __cplusplus
")glsl"
#endif
