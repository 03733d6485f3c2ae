#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// Means over areas are of positions, less the mean depth of the picture, so that sums stay small; background is in none.
float crease_area_depth(float depth) { return depth > 0.0 && depth < crease_background ? depth : 0.0; }

vec3 crease_area_value(vec3 position, float centre) { return position + vec3(0.0, 0.0, centre); }

vec3 crease_area_position(vec3 value, float centre) { return value - vec3(0.0, 0.0, centre); }
#ifdef __cplusplus
")glsl"
#endif
