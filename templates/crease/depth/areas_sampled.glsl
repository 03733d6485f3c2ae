#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// The tables as the main pass reads them.
vec4 crease_areas_at(ivec3 texel) { return texelFetch(crease_area_tables, texel, 0); }

ivec2 crease_areas_size() { return textureSize(crease_area_tables, 0).xy; }
#ifdef __cplusplus
")glsl"
#endif
