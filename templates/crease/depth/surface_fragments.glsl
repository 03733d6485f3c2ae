// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// The nearest of a texel, nearest first, and where the source finds their colors and normals.
struct crease_fragments {
    uint keys[32];
    uint places[32];
};

// Inserts a fragment, and returns how many fall out at the end.
uint crease_insert_fragment(inout crease_fragments sorted, uint key, uint place) {
    crease_unroll for (int i = 0; i < crease_most_surfaces; ++i) {
        bool nearer = key < sorted.keys[i];
        uvec2 farther = nearer ? uvec2(sorted.keys[i], sorted.places[i]) : uvec2(key, place);
        sorted.keys[i] = nearer ? key : sorted.keys[i];
        sorted.places[i] = nearer ? place : sorted.places[i];
        key = farther.x;
        place = farther.y;
    }
    return key != crease_no_fragment ? 1u : 0u;
}

crease_fragments crease_begin_fragments() {
    crease_fragments sorted;
    crease_unroll for (int i = 0; i < crease_most_surfaces; ++i) {
        sorted.keys[i] = crease_no_fragment;
        sorted.places[i] = 0u;
    }
    return sorted;
}
#ifdef __cplusplus
")glsl"
#endif
