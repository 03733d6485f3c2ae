// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
uint crease_kept_key(ivec2 texel, int layer);
#else
__LINE__, R"glsl("
#endif

// Of an array image in which they are sorted.
crease_fragments crease_sorted_fragments(ivec2 texel) {
    crease_fragments sorted;
    crease_unroll for (int i = 0; i < crease_most_surfaces; ++i) {
        sorted.keys[i] = crease_kept_key(texel, i);
        sorted.places[i] = uint(i);
    }
    return sorted;
}
#ifdef __cplusplus
")glsl"
#endif
