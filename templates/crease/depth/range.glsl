// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// The nearest, farthest and mean depth of the picture, which one texel holds; 0 where no texel counts.
float crease_range_nearest() { return crease_load_range(ivec2(0)).x; }

float crease_range_farthest() { return crease_load_range(ivec2(0)).y; }

float crease_range_mean() { return crease_load_range(ivec2(0)).z; }
#ifdef __cplusplus
")glsl"
#endif
