// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

const int crease_most_layers = crease_compressed_occluders_nodes;

const int crease_first_to_go = crease_compressed_occluders_half != 0 ? crease_compressed_occluders_nodes / 2 : 0;
#ifdef __cplusplus
")glsl"
#endif
