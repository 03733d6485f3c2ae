// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// The tables, as any pass that has them reads them.
vec4 crease_areas_at(ivec3 texel) { return crease_load_area_tables(texel); }

ivec2 crease_areas_size() { return crease_size_of_area_tables(); }
#ifdef __cplusplus
")glsl"
#endif
