// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
uint crease_fragment_key();
uint crease_pack_surface_normal(vec3 normal);
#else
__LINE__, R"glsl("
#endif

// Keeps the color, whose alpha is the opacity, and the normal of each fragment that has a layer. Fragments that are equal
// take their layers in the order in which they come; of a layer that no color has taken yet the color is 0.

// Called by the host's fragment shader, after its own alpha test. `anchor`: the position on the surface, as other
// captures take it; `normal`: view space, unit, as the triangle faces; `color`: linear, its alpha the opacity. What has
// none is not stored.
void crease_capture(vec3 anchor, vec3 normal, vec4 color) {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    uint key = crease_fragment_key(), packed_color = packUnorm4x8(color);
    if (packed_color >> 24u == 0u)
        return;
    for (int i = 0; i < crease_most_surfaces; ++i)
        if (crease_load_fragment_layers(ivec3(texel, i)).x == key &&
            imageAtomicCompSwap(crease_fragment_surfaces, ivec3(texel, i), 0u, packed_color) == 0u) {
            uint packed_normal = crease_pack_surface_normal(normal);
            imageStore(crease_fragment_surfaces, ivec3(texel, crease_most_surfaces + i), uvec4(packed_normal));
            return;
        }
}
#ifdef __cplusplus
")glsl"
#endif
