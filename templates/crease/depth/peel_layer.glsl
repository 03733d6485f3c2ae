// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
bool crease_lies_behind(uint key, uint layer);
#else
__LINE__, R"glsl("
#endif

// The nearest of what lies behind the layer that the pass before this one kept: depth peeling, Everitt 2001.
void crease_keep_fragment(uint key) {
    ivec3 place = ivec3(gl_FragCoord.xy, crease_peeling_index);
    if (place.z == 0 || crease_lies_behind(key, imageLoad(crease_fragment_layers, place - ivec3(0, 0, 1)).x))
        imageAtomicMin(crease_fragment_layers, place, key);
}
#ifdef __cplusplus
")glsl"
#endif
