// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// What rows are summed to; those of the tables that are made at once begin with 0.
void crease_scan_write(ivec3 at, vec4 sum) {
    imageStore(crease_area_rows, at - ivec3(0, 0, crease_scan_first), sum);
}
#ifdef __cplusplus
")glsl"
#endif
