// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// Linear depth, which an earlier pass has stored.
float crease_depth_at(vec2 texel) {
    vec2 there = crease_inside(texel) ? texel : crease_first_texel;
    return crease_load_linearised_depth(ivec2(there)).x;
}
#ifdef __cplusplus
")glsl"
#endif
