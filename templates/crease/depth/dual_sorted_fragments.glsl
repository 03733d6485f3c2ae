// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// Of an array image whose latter half holds complements. A last fragment between the others is the nearest and the farthest.
crease_fragments crease_sorted_fragments(ivec2 texel) {
    crease_fragments sorted;
    crease_unroll for (int i = 0; i < crease_most_layers; ++i) {
        uint stored = crease_load_fragment_layers(ivec3(texel, i)).x;
        bool is_near = 2 * i < crease_most_layers;
        bool is_there = is_near || stored != crease_no_fragment && ~stored != sorted.keys[crease_most_layers - 1 - i];
        sorted.keys[i] = !is_there ? crease_no_fragment : is_near ? stored : ~stored;
    }
    return sorted;
}
#ifdef __cplusplus
")glsl"
#endif
