#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// The front surface first, and the layers behind it only where they may matter: stochastic-depth-ao 6.3.

float crease_depth_at(vec2 texel);
vec3 crease_view_position(vec2 texel, float depth);
crease_contribution crease_weigh(crease_estimate estimate, crease_receiver receiver, crease_tap tap, vec3 position);
bool crease_front_settles(crease_estimate estimate, crease_receiver receiver, crease_tap tap, vec3 position);
crease_contribution crease_fold_groups(crease_estimate estimate, crease_receiver receiver, crease_tap tap,
                                       crease_contribution most, bool more);

crease_contribution crease_fold(crease_estimate estimate, crease_receiver receiver, crease_tap tap) {
    vec3 front = crease_view_position(tap.texel, crease_depth_at(tap.texel));
    vec3 to_front = front - receiver.position;
    float reach = crease_front_reach * crease_radius;
    bool near = dot(to_front, to_front) < reach * reach;
    bool settled =
        near || (crease_front_first_angle != 0 && crease_front_settles(estimate, receiver, tap, front));
    return crease_fold_groups(estimate, receiver, tap, crease_weigh(estimate, receiver, tap, front), !settled);
}
#ifdef __cplusplus
")glsl"
#endif
