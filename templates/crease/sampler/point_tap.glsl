#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// A tap at a point of view space, moved onto the ray through the centre of the texel that it falls into.
struct crease_tap {
    vec2 texel;
    bool inside; // whether the texel is in the depth image; else it has no weight
    vec3 offset; // from the receiver, view space
};
#ifdef __cplusplus
")glsl"
#endif
