// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
float crease_linear_depth(float device);
#else
__LINE__, R"glsl("
#endif

// Layers in the samples of a multisampled depth image.
float crease_captured_depth(ivec2 texel, int sample_index) {
    return crease_linear_depth(texelFetch(crease_captured_layers, texel, sample_index).x);
}
#ifdef __cplusplus
")glsl"
#endif
