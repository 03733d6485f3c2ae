// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// The half slice of a direction, in which angles count from the way to the eye. The measure of the cosine lobe in it,
// up to the angle t, is, with the normal's parts a along the way to the eye and b along the direction,
//     (a sin^2 t + b (t - sin t cos t)) / 2.
struct crease_half_slice {
    vec2 normal;   // a and b
    float tangent; // cosine of the angle of the tangent plane
    float share;   // measure up to there
};

// Up to the angle of this cosine.
float crease_half_slice_measure(vec2 normal, float cosine) {
    float sine = sqrt(1.0 - cosine * cosine);
    return 0.5 * (normal.x * sine * sine + normal.y * (acos(cosine) - sine * cosine));
}

crease_half_slice crease_half_slice_of(vec2 normal) {
    float tangent = clamp(-normal.y * inversesqrt(max(dot(normal, normal), 1e-12)), -1.0, 1.0); // in spite of rounding
    return crease_half_slice(normal, tangent, max(crease_half_slice_measure(normal, tangent), 0.0));
}

crease_half_slice crease_half_slice_along(crease_receiver receiver, vec2 direction) {
    vec3 azimuth = receiver.tangent * direction.x + receiver.bitangent * direction.y;
    return crease_half_slice_of(
        vec2(max(dot(receiver.normal, receiver.to_eye), 0.0), dot(receiver.normal, azimuth)));
}

// The normal in the half slice of a point, which its texel moves off the marched direction: so a plane is unoccluded at
// every slant.
vec2 crease_half_slice_normal(crease_half_slice slice, crease_receiver receiver, vec3 to_point) {
    float squared = dot(to_point, to_point), towards = dot(to_point, receiver.to_eye);
    float across = sqrt(max(squared - towards * towards, 1e-12 * squared));
    return vec2(slice.normal.x, (dot(to_point, receiver.normal) - slice.normal.x * towards) / across);
}
#ifdef __cplusplus
")glsl"
#endif
