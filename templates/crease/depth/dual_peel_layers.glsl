// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// The nearest and the farthest of what lies between the layers that the pass before this one kept: dual depth peeling,
// Bavoil and Myers 2008. The farthest stand at the end of the array, as complements, of which the least is kept too.
void crease_keep_fragment(uint key) {
    ivec3 nearest = ivec3(gl_FragCoord.xy, crease_peeling_index),
          farthest = ivec3(nearest.xy, crease_dual_peeled_layers_layers - 1 - nearest.z);
    if (nearest.z > 0 && !(key > imageLoad(crease_fragment_layers, nearest - ivec3(0, 0, 1)).x &&
                           ~key > imageLoad(crease_fragment_layers, farthest + ivec3(0, 0, 1)).x))
        return;
    imageAtomicMin(crease_fragment_layers, nearest, key);
    if (farthest.z > nearest.z)
        imageAtomicMin(crease_fragment_layers, farthest, ~key);
}
#ifdef __cplusplus
")glsl"
#endif
