// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// A scan of the layers that the pass before has split.
vec4 crease_scan_read(ivec3 at) { return crease_load_area_splits(at - ivec3(0, 0, crease_scan_first)); }
#ifdef __cplusplus
")glsl"
#endif
