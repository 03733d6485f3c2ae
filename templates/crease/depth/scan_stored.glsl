#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// A scan of what a pass before has stored.
vec4 crease_scan_read(ivec3 at) { return imageLoad(crease_area_tables, at); }

vec4 crease_scan_reread(ivec3 at) { return imageLoad(crease_area_tables, at); }
#ifdef __cplusplus
")glsl"
#endif
