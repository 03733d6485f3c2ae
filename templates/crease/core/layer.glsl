// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// A surface at a texel.
struct crease_layer {
    vec3 position; // view space
    float texels;  // it stands for: 1, or the number of texels of an area
};
#ifdef __cplusplus
")glsl"
#endif
