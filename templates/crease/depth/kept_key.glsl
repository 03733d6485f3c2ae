// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// The key of a layer of a texel.
uint crease_kept_key(ivec2 texel, int layer) { return crease_load_fragment_layers(ivec3(texel, layer)).x; }
#ifdef __cplusplus
")glsl"
#endif
