#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// What one texel tells of all depths of the picture; 0 where none counts.
float crease_range_nearest() { return imageLoad(crease_range, ivec2(0)).x; }

float crease_range_farthest() { return imageLoad(crease_range, ivec2(0)).y; }

float crease_range_mean() { return imageLoad(crease_range, ivec2(0)).z; }
#ifdef __cplusplus
")glsl"
#endif
