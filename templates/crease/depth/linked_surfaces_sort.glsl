// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
uint crease_insert_fragment(inout crease_fragments sorted, uint key, uint place);
crease_fragments crease_begin_fragments();
#else
__LINE__, R"glsl("
#endif

const uint crease_no_node = 0xffffffffu; // as a place: beside the pool

crease_fragments crease_sorted_fragments(ivec2 texel) {
    crease_fragments sorted = crease_begin_fragments();
    crease_insert_fragment(sorted, crease_load_list_heads(ivec3(texel, 0)).x, crease_no_node);
    uint beyond = 0u;
    uint node = crease_load_list_heads(ivec3(texel, 1)).x;
    while (node != crease_no_node) {
        uvec2 own = crease_list_nodes[node].yw;
        beyond += crease_insert_fragment(sorted, own.x, node);
        node = own.y;
    }
    if (beyond > 0u)
        atomicAdd(crease_fragments_beyond_layers[0], beyond);
    return sorted;
}

// The color and the normal of a fragment, packed.
uvec2 crease_fragment_surface(ivec2 texel, uint place) {
    if (place != crease_no_node)
        return crease_list_nodes[place].xz;
    return uvec2(crease_load_list_heads(ivec3(texel, 2)).x << 16u | (crease_load_list_heads(ivec3(texel, 3)).x & 0xffffu),
                 crease_load_list_heads(ivec3(texel, 4)).x << 16u | (crease_load_list_heads(ivec3(texel, 5)).x & 0xffffu));
}
#ifdef __cplusplus
")glsl"
#endif
