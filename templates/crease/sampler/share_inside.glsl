#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// How much of a way across the depth image stays in it, from 0 to 1: a march is cut at the picture's edge, so that a radius
// that is larger than the picture still finds what is there. `from` and `way` in texels, edges being whole numbers.
float crease_share_inside(vec2 from, vec2 way) {
    vec2 size = crease_depth_size();
    vec2 room = vec2(way.x > 0.0 ? size.x - from.x : from.x, way.y > 0.0 ? size.y - from.y : from.y);
    vec2 share = room / max(abs(way), vec2(1e-20));
    return clamp(min(share.x, share.y), 0.0, 1.0);
}
#ifdef __cplusplus
")glsl"
#endif
