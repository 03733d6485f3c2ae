// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
float crease_linear_depth(float device);
#else
__LINE__, R"glsl("
#endif

// The depth image holds device depth, as the depth buffer does.
float crease_depth_at(vec2 texel) {
    return crease_linear_depth(textureLod(crease_depth, (texel + 0.5) * crease_view.texel_size, 0.0).x);
}
#ifdef __cplusplus
")glsl"
#endif
