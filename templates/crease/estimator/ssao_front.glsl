#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// Where the front one is behind the point, all others are.
bool crease_front_settles(crease_estimate estimate, crease_receiver receiver, crease_tap tap, vec3 position) {
    return position.z < tap.point.z;
}

// Only layers before the point occlude it.
bool crease_may_occlude(crease_receiver receiver, crease_tap tap, vec4 depths) {
    return any(lessThanEqual(depths, vec4(-tap.point.z)));
}
#ifdef __cplusplus
")glsl"
#endif
