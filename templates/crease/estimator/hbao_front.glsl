#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
float crease_hbao_sine(crease_estimate estimate, float squared, float height);

// Of all layers of a texel the front one has the greatest angle; if that is below the horizon, so are the others.
bool crease_front_settles(crease_estimate estimate, crease_receiver receiver, crease_tap tap, vec3 position) {
    vec3 to_front = position - receiver.position;
    float sine = crease_hbao_sine(estimate, dot(to_front, to_front), dot(to_front, receiver.normal));
    return !(sine > estimate.horizon);
}
#ifdef __cplusplus
")glsl"
#endif
