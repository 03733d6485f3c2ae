// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// The columns of sums of rows, of which the tables are.
vec4 crease_scan_read(ivec3 at) { return crease_load_area_rows(at - ivec3(0, 0, crease_scan_first)); }

void crease_scan_write(ivec3 at, vec4 sum) { imageStore(crease_area_tables, at, sum); }
#ifdef __cplusplus
")glsl"
#endif
