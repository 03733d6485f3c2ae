// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// The depth image holds log2(1 + w) / log2(1 + far) of the distance w along the view.
float crease_depth_at(vec2 texel) {
    float stored = textureLod(crease_depth, (texel + 0.5) * crease_view.texel_size, 0.0).x;
    float depth = exp2(stored * log2(1.0 + crease_logarithmic_depth_far)) - 1.0;
    return depth > 0.0 && depth < crease_far_share * crease_logarithmic_depth_far ? depth : crease_background;
}
#ifdef __cplusplus
")glsl"
#endif
