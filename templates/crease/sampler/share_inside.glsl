// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// How much of a way across the depth image stays in it, from 0 to 1: a march is cut at the picture's edge, so that a
// radius that is larger than the picture still finds what is there. `from` and `way` in texels, edges being whole
// numbers.
float crease_share_inside(vec2 from, vec2 way) {
    vec2 after = crease_depth_size() - from;
    vec2 share = vec2(way.x < 0.0 ? from.x : after.x, way.y < 0.0 ? from.y : after.y) * abs(1.0 / way);
    return clamp(min(share.x, share.y), 0.0, 1.0);
}
#ifdef __cplusplus
")glsl"
#endif
