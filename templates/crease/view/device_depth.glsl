#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// The depth image holds device depth, as the depth buffer does.

float crease_linear_depth(float device);

float crease_depth_at(vec2 texel) {
    float depth = crease_linear_depth(textureLod(crease_depth, texel * crease_texel_size, 0.0).x);
    return depth < crease_far_depth ? depth : crease_background; // the far plane is no occluder, nor is NaN
}
#ifdef __cplusplus
")glsl"
#endif
