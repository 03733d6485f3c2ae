// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
uint crease_fragment_key();
#else
__LINE__, R"glsl("
#endif

// Counts the fragments of a texel that have opacity, and finds the nearest.

// Called by the host's fragment shader, after its own alpha test. `anchor`: the position on the surface, as other
// captures take it; `normal`: view space, unit, as the triangle faces; `color`: linear, its alpha the opacity.
void crease_capture(vec3 anchor, vec3 normal, vec4 color) {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    if (packUnorm4x8(color) >> 24u == 0u)
        return;
    imageAtomicAdd(crease_list_places, ivec3(texel, 0), 1u);
    imageAtomicMin(crease_nearest_fragments, texel, crease_fragment_key());
}
#ifdef __cplusplus
")glsl"
#endif
