// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
uint crease_fragment_key();
bool crease_next_node(ivec2 texel, out uint node);
#else
__LINE__, R"glsl("
#endif

// Stores a fragment in the next node of its texel's list: a-buffer-ssao 2013, IV.B. The nearest has a place of its own,
// which a full pool does not take from it.

// Called by the host's fragment shader, after its own alpha test. `anchor`: the position on the surface, as other
// captures take it.
void crease_capture(vec3 anchor) {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    uint key = crease_fragment_key();
    uint farther = max(key, imageAtomicMin(crease_nearest_fragments, texel, key));
    if (farther == crease_no_fragment)
        return;
    uint node;
    if (crease_next_node(texel, node))
        crease_list_nodes[node] = farther;
}
#ifdef __cplusplus
")glsl"
#endif
