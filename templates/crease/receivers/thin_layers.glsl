// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
crease_receiver crease_turned_round(crease_receiver receiver);
crease_result crease_result_of(crease_receiver receiver);
crease_result crease_weighted(crease_result result, float weight);
crease_result crease_sum(crease_result a, crease_result b);
#else
__LINE__, R"glsl("
#endif

const int crease_receiver_sides = 2;

float crease_eye_side(crease_receiver receiver) { return sign(receiver.to_eye.z); }

// Background is behind all, whichever side looks.
float crease_layer_before(crease_receiver receiver, crease_layer layer) {
    float before = layer.position.z - receiver.position.z;
    return layer.position.z > -0.5 * crease_background ? crease_eye_side(receiver) * before : before;
}

// Of a thin hull both sides, the exterior and the interior: a-buffer-ssao 2013, equations (2) to (4). W is the opacity where
// a front face is seen, and 1 less that where a back face is: either way the side that is seen counts by the opacity. The
// other is that side of a receiver which is looked at from behind.
crease_result crease_result_of_surface(crease_receiver receiver, float opacity) {
    crease_result both = crease_weighted(crease_result_of(receiver), opacity);
    crease_result other = crease_result_of(crease_turned_round(receiver));
    return crease_sum(both, crease_weighted(other, 1.0 - opacity));
}
#ifdef __cplusplus
")glsl"
#endif
