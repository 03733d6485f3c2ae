// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
crease_fragments crease_sorted_fragments(ivec2 texel);
void crease_order_equal_fragments(ivec2 texel, inout crease_fragments sorted);
void crease_pack_fragments(ivec2 texel, crease_fragments sorted);
#else
__LINE__, R"glsl("
#endif

// The depth image says nothing of layers with opacity: all are kept.
void crease_build(ivec2 texel) {
    crease_fragments sorted = crease_sorted_fragments(texel);
    crease_order_equal_fragments(texel, sorted);
    crease_pack_fragments(texel, sorted);
}
#ifdef __cplusplus
")glsl"
#endif
