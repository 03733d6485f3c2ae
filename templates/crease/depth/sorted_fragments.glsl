// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// Of an array image in which they are sorted.
crease_fragments crease_sorted_fragments(ivec2 texel) {
    crease_fragments sorted;
    crease_unroll for (int i = 0; i < crease_most_layers; ++i)
        sorted.keys[i] = crease_load_fragment_layers(ivec3(texel, i)).x;
    return sorted;
}
#ifdef __cplusplus
")glsl"
#endif
