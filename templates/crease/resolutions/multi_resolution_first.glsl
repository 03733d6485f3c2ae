// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
uvec4 crease_layer_to_halve(vec2 texel, int i);
#else
__LINE__, R"glsl("
#endif

// The picture of half the size, of what the depth source keeps.
uvec4 crease_finer_layer(ivec2 texel, int i) {
    return crease_layer_to_halve(min(vec2(texel), crease_depth_size() - 1.0), i);
}
#ifdef __cplusplus
")glsl"
#endif
