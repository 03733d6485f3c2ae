// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// A tap at a point of view space, moved onto the ray through the centre of the texel that it falls into.
struct crease_tap {
    vec2 texel;
    bool inside; // whether the texel is in the depth image; else it has no weight
    vec3 offset; // from the receiver, view space
};

// The height over the tangent plane up to which a point is left out, as rounding may put it on either side of the
// surface: a share of the radius, or of the depth where the radius is larger.
float crease_point_bias(crease_receiver receiver, float bias) {
    return bias * min(crease_radius, -receiver.position.z);
}
#ifdef __cplusplus
")glsl"
#endif
