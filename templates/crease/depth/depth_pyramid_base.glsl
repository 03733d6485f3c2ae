// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
float crease_depth_at(vec2 texel);
#else
__LINE__, R"glsl("
#endif

// The first level: the linear depth of each texel.
void crease_build(ivec2 texel) {
    imageStore(crease_depth_pyramid, texel, vec4(crease_depth_at(vec2(texel))));
}
#ifdef __cplusplus
")glsl"
#endif
