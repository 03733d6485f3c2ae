#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// The tables, as any pass that has them reads them.
vec4 crease_areas_at(ivec3 texel) { return imageLoad(crease_area_tables, texel); }

ivec2 crease_areas_size() { return imageSize(crease_area_tables).xy; }
#ifdef __cplusplus
")glsl"
#endif
