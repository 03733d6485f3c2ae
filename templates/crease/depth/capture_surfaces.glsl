// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
int crease_claim_layer(ivec2 texel, vec4 color);
uint crease_pack_surface_normal(vec3 normal);
#else
__LINE__, R"glsl("
#endif

// Keeps the color, whose alpha is the opacity, and the normal of each fragment that has a layer.

// Called by the host's fragment shader, after its own alpha test. `anchor`: the position on the surface, as other
// captures take it; `normal`: view space, unit, as the triangle faces; `color`: linear, its alpha the opacity. What has
// none is not stored.
void crease_capture(vec3 anchor, vec3 normal, vec4 color) {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    int layer = crease_claim_layer(texel, color);
    if (layer >= 0)
        imageStore(crease_fragment_surfaces, ivec3(texel, crease_most_surfaces + layer),
                   uvec4(crease_pack_surface_normal(normal)));
}
#ifdef __cplusplus
")glsl"
#endif
