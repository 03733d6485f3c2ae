#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// Where the front one is behind the point, all others are.
bool crease_front_settles(crease_estimate estimate, crease_receiver receiver, crease_tap tap, vec3 position) {
    return position.z - receiver.position.z - estimate.rounding < tap.offset.z;
}
#ifdef __cplusplus
")glsl"
#endif
