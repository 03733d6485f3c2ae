#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// Layers lie in groups of four, one in each component of a texel.
int crease_layer_count() { return crease_stochastic_layers_count; }

int crease_group_count() { return (crease_stochastic_layers_count + 3) / 4; }
#ifdef __cplusplus
")glsl"
#endif
