// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// What one texel tells of all depths of the picture; 0 where none counts.
float crease_range_nearest() { return crease_load_range(ivec2(0)).x; }

float crease_range_farthest() { return crease_load_range(ivec2(0)).y; }

float crease_range_mean() { return crease_load_range(ivec2(0)).z; }
#ifdef __cplusplus
")glsl"
#endif
