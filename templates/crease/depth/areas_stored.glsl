#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// The tables as a pass reads them that makes further ones.
vec4 crease_areas_at(ivec3 texel) { return imageLoad(crease_area_tables, texel); }

ivec2 crease_areas_size() { return imageSize(crease_area_tables).xy; }

int crease_areas_divisor() { return crease_divisor; }
#ifdef __cplusplus
")glsl"
#endif
