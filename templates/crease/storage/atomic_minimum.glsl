// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// Layers in an array image that holds the bits of their linear depths; where there is none, they are those of a NaN.
float crease_captured_depth(ivec2 texel, int sample_index) {
    return uintBitsToFloat(crease_load_captured_layers(ivec3(texel, sample_index)).x);
}
#ifdef __cplusplus
")glsl"
#endif
