// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
crease_nodes crease_compress(ivec2 texel, crease_fragments sorted);
void crease_store_nodes(ivec2 texel, crease_nodes nodes);
#else
__LINE__, R"glsl("
#endif

void crease_pack_fragments(ivec2 texel, crease_fragments sorted) {
    crease_store_nodes(texel, crease_compress(texel, sorted));
}
#ifdef __cplusplus
")glsl"
#endif
