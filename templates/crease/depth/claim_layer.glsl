// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
uint crease_fragment_key();
uint crease_kept_key(ivec2 texel, int layer);
#else
__LINE__, R"glsl("
#endif

// The layer in which a fragment's color is kept, -1 where it has none. Fragments that are equal take their layers in the
// order in which they come; of a layer that no color has taken yet the color is 0.
int crease_claim_layer(ivec2 texel, vec4 color) {
    uint key = crease_fragment_key(), packed_color = packUnorm4x8(color);
    if (packed_color >> 24u == 0u)
        return -1;
    for (int i = 0; i < crease_most_surfaces; ++i)
        if (crease_kept_key(texel, i) == key &&
            imageAtomicCompSwap(crease_fragment_surfaces, ivec3(texel, i), 0u, packed_color) == 0u)
            return i;
    return -1;
}
#ifdef __cplusplus
")glsl"
#endif
