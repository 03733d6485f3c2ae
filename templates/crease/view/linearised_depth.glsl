#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// A pass before has stored linear depth.
float crease_depth_at(vec2 texel) {
    vec2 there = crease_inside(texel) ? texel : crease_first_texel;
    return imageLoad(crease_linearised_depth, ivec2(there)).x;
}
#ifdef __cplusplus
")glsl"
#endif
