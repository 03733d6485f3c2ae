#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// Whether one of four layers is as near in depth as the radius: further than that, none occludes.
bool crease_may_occlude(crease_receiver receiver, crease_tap tap, vec4 depths) {
    return any(lessThan(abs(depths + receiver.position.z), vec4(crease_radius)));
}
#ifdef __cplusplus
")glsl"
#endif
