// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
float crease_linear_depth(float device);
#else
__LINE__, R"glsl("
#endif

// Stores the linear depth of each texel of the depth buffer.
void crease_build(ivec2 texel) {
    float device = textureLod(crease_depth, (vec2(texel) + 0.5) * crease_view.texel_size, 0.0).x;
    imageStore(crease_linearised_depth, texel, vec4(crease_linear_depth(device)));
}
#ifdef __cplusplus
")glsl"
#endif
