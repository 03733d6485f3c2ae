// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
uvec2 crease_list_range(ivec2 texel);
crease_fragments crease_sorted_first(uint nearest);
uint crease_insert_fragment(inout crease_fragments sorted, uint key);
#else
__LINE__, R"glsl("
#endif

// Inserts one fragment after another, and counts those that fall out at the end.
crease_fragments crease_sorted_fragments(ivec2 texel) {
    crease_fragments sorted = crease_sorted_first(crease_load_nearest_fragments(texel).x);
    uvec2 range = crease_list_range(texel);
    uint stored = crease_load_list_places(ivec3(texel, 1)).x;
    uint end = min(min(range.x + stored, range.y), uint(crease_list_nodes.length()));
    uint beyond = 0u;
    for (uint node = range.x; node < end; ++node)
        beyond += crease_insert_fragment(sorted, crease_list_nodes[node]);
    if (beyond > 0u)
        atomicAdd(crease_fragments_beyond_layers[0], beyond);
    return sorted;
}
#ifdef __cplusplus
")glsl"
#endif
