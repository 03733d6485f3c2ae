// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// A tap that takes in an area of the depth image.
struct crease_tap {
    vec4 area;   // left, top, right and bottom edge, texels: that in the corner reaches from 0 to 1
    vec2 texel;  // in the middle
    bool inside; // whether any of it may be in the depth image; else it has no weight
};
#ifdef __cplusplus
")glsl"
#endif
