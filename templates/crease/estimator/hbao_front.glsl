#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
float crease_hbao_rise(crease_estimate estimate, float cosine);

// Of all layers of a texel the front one has the greatest angle; if that is below the horizon, so are the others.
bool crease_front_settles(crease_estimate estimate, crease_receiver receiver, crease_tap tap, vec3 position) {
    vec3 to_front = position - receiver.position;
    float cosine = dot(to_front, receiver.normal) * inversesqrt(dot(to_front, to_front));
    return !(crease_hbao_rise(estimate, cosine) > estimate.horizon);
}
#ifdef __cplusplus
")glsl"
#endif
