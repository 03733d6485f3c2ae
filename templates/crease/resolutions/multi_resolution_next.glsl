// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// A picture of half the size of the one before.
uvec4 crease_finer_layer(ivec2 texel, int i) {
    return crease_load_input(ivec3(min(texel, crease_size_of_input() - 1), i));
}
#ifdef __cplusplus
")glsl"
#endif
