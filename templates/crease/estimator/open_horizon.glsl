// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// Bent normals from horizons.

// The angle of this cosine and sine, up to a right angle: sine times a polynomial is at most 0.0006 off, and needs no
// square root as acos does.
float crease_horizon_angle(float cosine, float sine) {
    return sine * (1.570207 + cosine * (-0.974326 + cosine * (0.605502 - cosine * 0.205034)));
}

// The change of the normal where it is turned away from an occluder in `direction` by the angle of this cosine and
// sine: along the axes of the disk that faces the eye, and to the eye.
crease_open crease_turned_normal(crease_receiver receiver, vec2 direction, float cosine, float sine) {
    vec2 on_disk = vec2(dot(receiver.normal, receiver.tangent), dot(receiver.normal, receiver.bitangent));
    float along = dot(on_disk, direction), facing = dot(receiver.normal, receiver.to_eye);
    vec3 turn = vec3(direction * (along * (cosine - 1.0) - facing * sine), facing * (cosine - 1.0) + along * sine);
    return crease_open(turn, 1.0, crease_horizon_angle(cosine, sine));
}

// The sum of the directions' turned normals; the surface's own counts a little more, so that the sum is never zero.
vec3 crease_open_mean(crease_open open, crease_receiver receiver) {
    return receiver.normal * (open.weight + 1e-6) + receiver.tangent * open.sum.x + receiver.bitangent * open.sum.y +
        receiver.to_eye * open.sum.z;
}

// The cone's half angle: a right angle less the mean angle of the turns.
float crease_open_cone(crease_open open) { return 1.57079633 - open.turned / open.weight; }
#ifdef __cplusplus
")glsl"
#endif
