// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// Inserts a fragment into the layers of its texel, which stay sorted whatever comes first: each keeps the nearer of two
// fragments and hands the other on, so that the farthest fall out at the end.
void crease_keep_fragment(uint key) {
    for (int i = 0; i < crease_layer_array_layers && key != crease_no_fragment; ++i)
        key = max(key, imageAtomicMin(crease_fragment_layers, ivec3(gl_FragCoord.xy, i), key));
    if (key != crease_no_fragment)
        atomicAdd(crease_fragments_beyond_layers[0], 1u);
}
#ifdef __cplusplus
")glsl"
#endif
