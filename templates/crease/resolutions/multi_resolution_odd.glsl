// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// A pass reads one image and writes another, so the pictures of odd index have one and those of even index the other.
uint crease_load_coarser(ivec3 texel, int resolution) { return crease_load_even_occlusion(texel, resolution - 1).x; }

void crease_keep_occlusion(ivec3 texel, uint occlusion) {
    imageStore(crease_odd_occlusion, texel, uvec4(occlusion));
}
#ifdef __cplusplus
")glsl"
#endif
