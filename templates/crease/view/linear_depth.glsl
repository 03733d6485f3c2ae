// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// The depth image holds positive linear view depth.
float crease_depth_at(vec2 texel) {
    float depth = textureLod(crease_depth, (texel + 0.5) * crease_view.texel_size, 0.0).x;
    return depth > 0.0 && depth < crease_view.far_depth ? depth : crease_background; // 0 is a hole, not a surface at the eye
}
#ifdef __cplusplus
")glsl"
#endif
