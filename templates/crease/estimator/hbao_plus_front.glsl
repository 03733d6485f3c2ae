#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
vec3 crease_to_eye(vec3 position);

// Where the front one lies below the tangent plane, and going away from the eye leads further down, so do all others.
bool crease_front_settles(crease_estimate estimate, crease_receiver receiver, crease_tap tap, vec3 position) {
    return !(dot(position - receiver.position, receiver.normal) > 0.0) &&
        dot(crease_to_eye(position), receiver.normal) >= 0.0;
}
#ifdef __cplusplus
")glsl"
#endif
