// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// The nearest of what this pass draws.
void crease_keep_fragment(uint key) {
    imageAtomicMin(crease_fragment_layers, ivec3(gl_FragCoord.xy, crease_static_and_dynamic_layers_index), key);
}
#ifdef __cplusplus
")glsl"
#endif
