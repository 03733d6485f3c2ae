// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
float crease_range_mean();
vec3 crease_area_position(vec3 value, float centre);
#else
__LINE__, R"glsl("
#endif

// The position that stands for the mean of what a sum over a table holds.
vec3 crease_area_mean(vec4 sum) { return crease_area_position(sum.xzw / sum.y, crease_range_mean()); }
#ifdef __cplusplus
")glsl"
#endif
