#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// The result of a pixel of the main pass.

bool crease_receive(ivec2 pixel, out crease_receiver receiver);
crease_gathered crease_gather(crease_receiver receiver);
crease_result crease_conclude(crease_gathered gathered, crease_receiver receiver);
crease_result crease_open();

crease_result crease_evaluate(ivec2 pixel) {
    crease_receiver receiver;
    return crease_receive(pixel, receiver) ? crease_conclude(crease_gather(receiver), receiver) : crease_open();
}
#ifdef __cplusplus
")glsl"
#endif
