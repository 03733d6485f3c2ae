#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// Means over areas are of positions, less the mean depth of the picture, so that sums stay small; background is in none.
float crease_area_depth(float depth) { return depth > 0.0 && depth < crease_background ? depth : 0.0; }

vec3 crease_area_value(vec3 position, float centre) { return vec3(position.z + centre, position.xy); }

vec3 crease_area_position(vec3 value, float centre) { return vec3(value.yz, value.x - centre); }
#ifdef __cplusplus
")glsl"
#endif
