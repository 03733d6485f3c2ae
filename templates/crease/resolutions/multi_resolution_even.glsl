// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

void crease_keep_occlusion(ivec3 texel, uint occlusion) {
    imageStore(crease_even_occlusion, texel, uvec4(occlusion));
}
#ifdef __cplusplus
")glsl"
#endif
