// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// A scan of what the pass before has put where the tables will be.
vec4 crease_scan_read(ivec3 at) { return crease_load_area_tables(at); }
#ifdef __cplusplus
")glsl"
#endif
