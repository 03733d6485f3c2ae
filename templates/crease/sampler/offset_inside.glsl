#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// An offset from the receiver, cut where it leaves the picture or comes near the eye, so that a radius that is larger than
// the picture still finds what is there.

vec2 crease_texel_at(vec3 position);
float crease_share_inside(vec2 from, vec2 way);
float crease_share_of_way(float share, float from, float to);

vec3 crease_offset_inside(crease_receiver receiver, vec3 offset) {
    float depth = -receiver.position.z;
    offset *= min(1.0, 0.9 * depth / max(offset.z, 1e-20));
    vec2 way = crease_texel_at(receiver.position + offset) - receiver.texel;
    float share = crease_share_inside(receiver.texel + 0.5, way);
    return offset * crease_share_of_way(share, depth, depth - offset.z);
}
#ifdef __cplusplus
")glsl"
#endif
