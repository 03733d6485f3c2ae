#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// The visibility of a receiver and nothing else.

float crease_visibility_of(float occlusion);

crease_result crease_conclude(crease_gathered gathered, crease_receiver receiver) {
    return crease_result(crease_visibility_of(gathered.occlusion), -receiver.position.z);
}
#ifdef __cplusplus
")glsl"
#endif
