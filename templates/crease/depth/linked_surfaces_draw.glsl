// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
uint crease_fragment_key();
uint crease_pack_surface_normal(vec3 normal);
#else
__LINE__, R"glsl("
#endif

// Adds a fragment to the list of its texel: a-buffer-ssao 2013, IV. A node holds the color, whose alpha is the opacity, the
// key, the normal and the index of the next.

// The nearest of those that find the pool full has a place of its own. As no atomic operation takes a whole fragment, each
// 16 bits of its color and normal stand below the first 16 of its key; those of fragments whose keys begin alike may mix.
void crease_keep_beside_pool(ivec2 texel, uvec3 fragment) {
    uint nearest = imageAtomicMin(crease_list_heads, ivec3(texel, 0), fragment.y);
    uint first = fragment.y & 0xffff0000u;
    imageAtomicMin(crease_list_heads, ivec3(texel, 2), first | fragment.x >> 16u);
    imageAtomicMin(crease_list_heads, ivec3(texel, 3), first | (fragment.x & 0xffffu));
    imageAtomicMin(crease_list_heads, ivec3(texel, 4), first | fragment.z >> 16u);
    imageAtomicMin(crease_list_heads, ivec3(texel, 5), first | (fragment.z & 0xffffu));
    if (nearest != crease_no_fragment)
        atomicAdd(crease_fragments_beyond_pool[0], 1u);
}

// Called by the host's fragment shader, after its own alpha test. `anchor`: the position on the surface, as other
// captures take it; `normal`: view space, unit, as the triangle faces; `color`: linear, its alpha the opacity. What has
// none is not stored.
void crease_capture(vec3 anchor, vec3 normal, vec4 color) {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    uvec3 fragment = uvec3(packUnorm4x8(color), crease_fragment_key(), crease_pack_surface_normal(normal));
    if (fragment.x >> 24u == 0u)
        return;
    uint node = atomicAdd(crease_node_count[0], 1u);
    if (node < uint(crease_list_nodes.length()))
        crease_list_nodes[node] = uvec4(fragment, imageAtomicExchange(crease_list_heads, ivec3(texel, 1), node));
    else
        crease_keep_beside_pool(texel, fragment);
}
#ifdef __cplusplus
")glsl"
#endif
