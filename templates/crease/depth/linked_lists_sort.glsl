// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
crease_fragments crease_sorted_first(uint nearest);
uint crease_insert_fragment(inout crease_fragments sorted, uint key);
#else
__LINE__, R"glsl("
#endif

const uint crease_no_node = 0xffffffffu;

// Inserts one fragment after another, and counts those that fall out at the end.
crease_fragments crease_sorted_fragments(ivec2 texel) {
    crease_fragments sorted = crease_sorted_first(crease_load_list_heads(ivec3(texel, 0)).x);
    uint beyond = 0u;
    uint node = crease_load_list_heads(ivec3(texel, 1)).x;
    while (node != crease_no_node) {
        beyond += crease_insert_fragment(sorted, crease_list_nodes[node].x);
        node = crease_list_nodes[node].y;
    }
    if (beyond > 0u)
        atomicAdd(crease_fragments_beyond_layers[0], beyond);
    return sorted;
}
#ifdef __cplusplus
")glsl"
#endif
