#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// The normal, turned away from what stands in a direction by the angle with this cosine and sine.
vec3 crease_bent_turn(crease_receiver receiver, vec2 direction, float cosine, float sine) {
    vec3 axis = cross(receiver.to_eye, receiver.across * direction.x + receiver.up * direction.y);
    return receiver.normal * cosine - cross(axis, receiver.normal) * sine +
        axis * (dot(axis, receiver.normal) * (1.0 - cosine));
}

// The mean of the directions' cones.
float crease_bend_cone(crease_bend bend) { return bend.cone / bend.weight; }
#ifdef __cplusplus
")glsl"
#endif
