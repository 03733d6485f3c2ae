#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
float crease_hbao_rise(crease_estimate estimate, crease_receiver receiver, vec3 to_tap, float squared, float height);

// Of all layers of a texel the front one rises the most; if that is below the horizon, so are the others.
bool crease_front_settles(crease_estimate estimate, crease_receiver receiver, crease_tap tap, vec3 position) {
    vec3 to_front = position - receiver.position;
    float rise = crease_hbao_rise(estimate, receiver, to_front, dot(to_front, to_front),
                                  dot(to_front, receiver.normal));
    return !(rise > estimate.rise);
}
#ifdef __cplusplus
")glsl"
#endif
