// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
uint crease_fragment_key();
#else
__LINE__, R"glsl("
#endif

// The nearest of what lies behind the layer that the pass before this one kept: depth peeling, Everitt 2001.

// Called by the host's fragment shader, after its own alpha test. `anchor`: the position on the surface, as other
// captures take it.
void crease_capture(vec3 anchor) {
    ivec3 place = ivec3(gl_FragCoord.xy, crease_peeled_layers_index);
    uint key = crease_fragment_key();
    if (place.z == 0 || key > imageLoad(crease_fragment_layers, place - ivec3(0, 0, 1)).x)
        imageAtomicMin(crease_fragment_layers, place, key);
}
#ifdef __cplusplus
")glsl"
#endif
