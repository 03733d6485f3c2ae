// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
uint crease_kept_key(ivec2 texel, int layer);
crease_fragments crease_begin_fragments();
#else
__LINE__, R"glsl("
#endif

// Of an array image whose nearest stand at the beginning and whose farthest stand at the end, without the gap between them.
crease_fragments crease_sorted_fragments(ivec2 texel) {
    int nearest = 0, gap = 0;
    crease_unroll for (int i = 0; i < crease_most_surfaces; ++i)
        if (crease_kept_key(texel, i) == crease_no_fragment)
            ++gap;
        else if (gap == 0)
            ++nearest;
    crease_fragments sorted = crease_begin_fragments();
    crease_unroll for (int i = 0; i < crease_most_surfaces; ++i)
        if (i + gap < crease_most_surfaces) {
            int layer = i < nearest ? i : i + gap;
            sorted.keys[i] = crease_kept_key(texel, layer);
            sorted.places[i] = uint(layer);
        }
    return sorted;
}
#ifdef __cplusplus
")glsl"
#endif
