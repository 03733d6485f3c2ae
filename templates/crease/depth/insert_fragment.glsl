// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// The nearest fragment of a texel alone, to which others are inserted; that of an empty texel is crease_no_fragment.
crease_fragments crease_sorted_first(uint nearest) {
    crease_fragments sorted;
    sorted.keys[0] = nearest;
    crease_unroll for (int i = 1; i < crease_most_layers; ++i)
        sorted.keys[i] = crease_no_fragment;
    return sorted;
}

// Inserts a fragment, which the nearest is not behind, and returns how many fall out at the end.
uint crease_insert_fragment(inout crease_fragments sorted, uint key) {
    crease_unroll for (int i = 1; i < crease_most_layers; ++i) {
        uint nearer = min(key, sorted.keys[i]);
        key = max(key, sorted.keys[i]);
        sorted.keys[i] = nearer;
    }
    return key != crease_no_fragment ? 1u : 0u;
}
#ifdef __cplusplus
")glsl"
#endif
