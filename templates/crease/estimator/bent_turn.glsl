#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// By how much a normal moves that is turned away from what stands in a direction, by the angle with this cosine and sine:
// along the axes of the disk that faces the eye, and to the eye.
vec3 crease_bent_turn(crease_receiver receiver, vec2 direction, float cosine, float sine) {
    vec2 on_disk = vec2(dot(receiver.normal, receiver.across), dot(receiver.normal, receiver.up));
    float along = dot(on_disk, direction), facing = dot(receiver.normal, receiver.to_eye);
    return vec3(direction * (along * (cosine - 1.0) - facing * sine), facing * (cosine - 1.0) + along * sine);
}

// The angle with this cosine and sine: as sine times a polynomial it is at most 0.0006 off up to a right angle, and has no
// root as acos has.
float crease_bent_angle(float cosine, float sine) {
    return sine * (1.570207 + cosine * (-0.974326 + cosine * (0.605502 - cosine * 0.205034)));
}

// The sum of the directions' normals: the surface's own, a little more often lest they cancel each other, and by how much
// they moved.
vec3 crease_bend_direction(crease_bend bend, crease_receiver receiver) {
    return receiver.normal * (bend.weight + 1e-6) + receiver.across * bend.sum.x + receiver.up * bend.sum.y +
        receiver.to_eye * bend.sum.z;
}

// The mean of the directions' cones: what the turns leave of a right angle.
float crease_bend_cone(crease_bend bend) { return 1.57079633 - bend.turned / bend.weight; }
#ifdef __cplusplus
")glsl"
#endif
