// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// 1, or -1 where the receiver is looked at from behind.
float crease_eye_side(crease_receiver receiver) { return 1.0; }

// Sides of a surface that receive.
const int crease_receiver_sides = 1;

// The receiver as it is looked at from the other side.
crease_receiver crease_turned_round(crease_receiver receiver) {
    receiver.normal = -receiver.normal;
    receiver.to_eye = -receiver.to_eye;
    return receiver;
}

// How much nearer to the eye a layer is than the receiver, in depth.
float crease_layer_before(crease_receiver receiver, crease_layer layer) {
    return layer.position.z - receiver.position.z;
}
#ifdef __cplusplus
")glsl"
#endif
