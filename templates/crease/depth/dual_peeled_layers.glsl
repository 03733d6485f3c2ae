// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

const int crease_most_layers = crease_dual_peeled_layers_layers;

const int crease_most_surfaces = crease_dual_peeled_layers_layers;
#ifdef __cplusplus
")glsl"
#endif
