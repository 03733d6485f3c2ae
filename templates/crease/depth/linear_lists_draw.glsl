// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
uint crease_fragment_key();
uvec2 crease_list_range(ivec2 texel);
#else
__LINE__, R"glsl("
#endif

// Stores a fragment in the next node of its texel's list: a-buffer-ssao 2013, IV.B. The nearest has a place of its own,
// which a full pool does not take from it. A fragment that was not counted finds no node, as those behind it are others'.

// Called by the host's fragment shader, after its own alpha test. `anchor`: the position on the surface, as other
// captures take it.
void crease_capture(vec3 anchor) {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    uint key = crease_fragment_key();
    uint farther = max(key, imageAtomicMin(crease_nearest_fragments, texel, key));
    if (farther == crease_no_fragment)
        return;
    uvec2 range = crease_list_range(texel);
    uint node = range.x + imageAtomicAdd(crease_list_places, ivec3(texel, 1), 1u);
    if (node < min(range.y, uint(crease_list_nodes.length())))
        crease_list_nodes[node] = farther;
    else
        atomicAdd(crease_fragments_beyond_pool[0], 1u);
}
#ifdef __cplusplus
")glsl"
#endif
