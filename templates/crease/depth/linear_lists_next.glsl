// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
uvec2 crease_list_range(ivec2 texel);
#else
__LINE__, R"glsl("
#endif

// The next node of a texel's list, or none, which is counted. A fragment that was not counted finds none, as those behind
// are others'.
bool crease_next_node(ivec2 texel, out uint node) {
    uvec2 range = crease_list_range(texel);
    node = range.x + imageAtomicAdd(crease_list_places, ivec3(texel, 1), 1u);
    bool found = node < min(range.y, uint(crease_list_nodes.length()));
    if (!found)
        atomicAdd(crease_fragments_beyond_pool[0], 1u);
    return found;
}
#ifdef __cplusplus
")glsl"
#endif
