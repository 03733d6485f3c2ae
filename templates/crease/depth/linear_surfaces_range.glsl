// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// The nodes of the nearest fragments stand before all others, row after row.
int crease_own_node(ivec2 texel) { return texel.y * crease_size_of_list_places().x + texel.x; }

// The first node of the list of a texel's other fragments, and the one behind its last.
uvec2 crease_list_range(ivec2 texel) {
    ivec2 size = crease_size_of_list_places();
    uint first = texel.y > 0 ? crease_load_list_places(ivec3(texel.x, texel.y - 1, 0)).x : 0u;
    uint end = crease_load_list_places(ivec3(texel, 0)).x;
    return crease_column_starts[texel.x] + uint(size.x * size.y) + uvec2(first, end);
}
#ifdef __cplusplus
")glsl"
#endif
