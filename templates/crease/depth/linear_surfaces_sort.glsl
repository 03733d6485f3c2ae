// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
uvec2 crease_list_range(ivec2 texel);
int crease_own_node(ivec2 texel);
uint crease_insert_fragment(inout crease_fragments sorted, uint key, uint place);
crease_fragments crease_begin_fragments();
#else
__LINE__, R"glsl("
#endif

crease_fragments crease_sorted_fragments(ivec2 texel) {
    crease_fragments sorted = crease_begin_fragments();
    uint own = uint(crease_own_node(texel));
    if (crease_load_list_places(ivec3(texel, 2)).x != 0u)
        crease_insert_fragment(sorted, crease_list_nodes[own].y, own);
    uvec2 range = crease_list_range(texel);
    uint stored = crease_load_list_places(ivec3(texel, 1)).x;
    uint end = min(min(range.x + stored, range.y), uint(crease_list_nodes.length()));
    uint beyond = 0u;
    for (uint node = range.x; node < end; ++node)
        beyond += crease_insert_fragment(sorted, crease_list_nodes[node].y, node);
    if (beyond > 0u)
        atomicAdd(crease_fragments_beyond_layers[0], beyond);
    return sorted;
}

// The color and the normal of a fragment, packed.
uvec2 crease_fragment_surface(ivec2 texel, uint place) { return crease_list_nodes[place].xz; }
#ifdef __cplusplus
")glsl"
#endif
