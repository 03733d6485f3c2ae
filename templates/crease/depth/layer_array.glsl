// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

const int crease_most_layers = crease_layer_array_layers;

const int crease_most_surfaces = crease_layer_array_layers;
#ifdef __cplusplus
")glsl"
#endif
