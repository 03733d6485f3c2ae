// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// The key of the layer of what this pass draws.
uint crease_kept_key(ivec2 texel, int layer) {
    return layer == crease_static_and_dynamic_layers_index ? crease_load_fragment_layers(ivec3(texel, layer)).x
                                                           : crease_no_fragment;
}
#ifdef __cplusplus
")glsl"
#endif
