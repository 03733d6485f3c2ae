#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// The front surface of each tap, and at once what lies behind it: stochastic-depth-ao 6.3.

vec3 crease_view_position(vec2 texel, float depth);
crease_contribution crease_weigh(crease_estimate estimate, crease_receiver receiver, crease_tap tap, vec3 position);
float crease_front_of(crease_layers layers);
bool crease_look_behind(crease_estimate estimate, crease_receiver receiver, crease_tap tap, vec3 front, bool by_angle);
crease_contribution crease_fold_groups(crease_estimate estimate, crease_receiver receiver, crease_tap tap,
                                       crease_contribution most, int first, bool look);

crease_contribution crease_fold(crease_estimate estimate, crease_receiver receiver, crease_tap tap,
                                crease_layers layers) {
    vec3 front = crease_view_position(tap.texel, crease_front_of(layers));
    return crease_fold_groups(estimate, receiver, tap, crease_weigh(estimate, receiver, tap, front), 0,
                              crease_look_behind(estimate, receiver, tap, front, crease_front_first_angle != 0));
}
#ifdef __cplusplus
")glsl"
#endif
