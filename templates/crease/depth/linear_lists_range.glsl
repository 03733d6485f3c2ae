// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// The first node of a texel's list, and the one behind its last: lists stand one after another down each column.
uvec2 crease_list_range(ivec2 texel) {
    uint first = texel.y > 0 ? crease_load_list_places(ivec3(texel.x, texel.y - 1, 0)).x : 0u;
    uint end = crease_load_list_places(ivec3(texel, 0)).x;
    return crease_column_starts[texel.x] + uvec2(first, end);
}
#ifdef __cplusplus
")glsl"
#endif
