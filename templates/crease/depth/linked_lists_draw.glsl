// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
uint crease_fragment_key();
#else
__LINE__, R"glsl("
#endif

// Adds a fragment to the list of its texel: a-buffer-ssao 2013, IV.A. The nearest has a place of its own, which a full
// pool does not take from it; a node holds a key and the index of the next.

// Called by the host's fragment shader, after its own alpha test. `anchor`: the position on the surface, as other
// captures take it.
void crease_capture(vec3 anchor) {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    uint key = crease_fragment_key();
    uint farther = max(key, imageAtomicMin(crease_list_heads, ivec3(texel, 0), key));
    if (farther == crease_no_fragment)
        return;
    uint node = atomicAdd(crease_node_count[0], 1u);
    if (node < uint(crease_list_nodes.length()))
        crease_list_nodes[node] = uvec2(farther, imageAtomicExchange(crease_list_heads, ivec3(texel, 1), node));
    else
        atomicAdd(crease_fragments_beyond_pool[0], 1u);
}
#ifdef __cplusplus
")glsl"
#endif
