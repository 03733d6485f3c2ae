// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// Of an array image in which they are sorted.
crease_fragments crease_sorted_fragments(ivec2 texel) {
    crease_fragments sorted;
    crease_unroll for (int i = 0; i < crease_most_surfaces; ++i) {
        sorted.keys[i] = crease_load_fragment_layers(ivec3(texel, i)).x;
        sorted.places[i] = uint(i);
    }
    return sorted;
}

// The color and the normal of a fragment, packed.
uvec2 crease_fragment_surface(ivec2 texel, uint place) {
    return uvec2(crease_load_fragment_surfaces(ivec3(texel, place)).x,
                 crease_load_fragment_surfaces(ivec3(texel, crease_most_surfaces + int(place))).x);
}
#ifdef __cplusplus
")glsl"
#endif
