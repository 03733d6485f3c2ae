// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

const uint crease_no_node = 0xffffffffu;

// Inserts one fragment after another, and counts those that fall out at the end.
crease_fragments crease_sorted_fragments(ivec2 texel) {
    crease_fragments sorted;
    sorted.keys[0] = crease_load_list_heads(ivec3(texel, 0)).x;
    crease_unroll for (int i = 1; i < crease_most_layers; ++i)
        sorted.keys[i] = crease_no_fragment;
    uint beyond = 0u;
    uint node = crease_load_list_heads(ivec3(texel, 1)).x;
    while (node != crease_no_node) {
        uint key = crease_list_nodes[node].x;
        crease_unroll for (int i = 1; i < crease_most_layers; ++i) {
            uint nearer = min(key, sorted.keys[i]);
            key = max(key, sorted.keys[i]);
            sorted.keys[i] = nearer;
        }
        beyond += key != crease_no_fragment ? 1u : 0u;
        node = crease_list_nodes[node].y;
    }
    if (beyond > 0u)
        atomicAdd(crease_fragments_beyond_layers[0], beyond);
    return sorted;
}
#ifdef __cplusplus
")glsl"
#endif
