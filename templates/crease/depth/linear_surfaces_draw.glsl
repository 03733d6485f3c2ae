// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
uint crease_fragment_key();
uint crease_pack_surface_normal(vec3 normal);
bool crease_next_node(ivec2 texel, out uint node);
int crease_own_node(ivec2 texel);
#else
__LINE__, R"glsl("
#endif

// Stores a fragment in the next node of its texel's list: a-buffer-ssao 2013, IV.B. A node holds the color, whose alpha is
// the opacity, the key and the normal. The nearest, which the count has found, has a node of its own, so that no full pool
// takes that from it; of equal ones the first to come has it.

// Called by the host's fragment shader, after its own alpha test. `anchor`: the position on the surface, as other
// captures take it; `normal`: view space, unit, as the triangle faces; `color`: linear, its alpha the opacity. What has
// none is not stored.
void crease_capture(vec3 anchor, vec3 normal, vec4 color) {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    uvec4 fragment = uvec4(packUnorm4x8(color), crease_fragment_key(), crease_pack_surface_normal(normal), 0u);
    if (fragment.x >> 24u == 0u)
        return;
    if (fragment.y <= imageLoad(crease_nearest_fragments, texel).x &&
        imageAtomicExchange(crease_list_places, ivec3(texel, 2), 1u) == 0u) {
        crease_list_nodes[crease_own_node(texel)] = fragment;
        return;
    }
    uint node;
    if (crease_next_node(texel, node))
        crease_list_nodes[node] = fragment;
}
#ifdef __cplusplus
")glsl"
#endif
