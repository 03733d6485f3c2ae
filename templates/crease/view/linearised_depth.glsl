#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// A pass before has stored linear depth.
float crease_depth_at(vec2 texel) {
    return imageLoad(crease_linearised_depth, ivec2(texel + crease_view.guard)).x;
}
#ifdef __cplusplus
")glsl"
#endif
