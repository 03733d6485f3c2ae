#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// The front surface first, and the layers behind it only where they may matter: stochastic-depth-ao 6.3.

float crease_depth_at(vec2 texel);
vec3 crease_view_position(vec2 texel, float depth);
crease_contribution crease_weigh(crease_estimate estimate, crease_receiver receiver, crease_tap tap, vec3 position);
bool crease_front_settles(crease_estimate estimate, crease_receiver receiver, crease_tap tap, vec3 position);
bool crease_may_occlude(crease_receiver receiver, crease_tap tap, vec4 depths);
int crease_group_count();
vec4 crease_fetch_group(vec2 texel, int group);
crease_contribution crease_fold_layer(crease_estimate estimate, crease_receiver receiver, crease_tap tap,
                                      crease_contribution most, float depth);
crease_contribution crease_fold_others(crease_estimate estimate, crease_receiver receiver, crease_tap tap,
                                       crease_contribution most, vec4 depths);

crease_contribution crease_fold(crease_estimate estimate, crease_receiver receiver, crease_tap tap,
                                crease_layers layers) {
    vec3 front = crease_view_position(tap.texel, crease_depth_at(tap.texel));
    crease_contribution most = crease_weigh(estimate, receiver, tap, front);
    vec3 to_front = front - receiver.position;
    float reach = crease_front_reach * crease_radius;
    bool near = dot(to_front, to_front) < reach * reach;
    bool settled =
        near || (crease_front_first_angle != 0 && crease_front_settles(estimate, receiver, tap, front));
    // A loop also of one group, as invocations that run together leave it where none of them needs it.
    vec4 depths = layers.depths;
    bool look = !settled && (crease_group_count() > 1 || crease_may_occlude(receiver, tap, depths));
    for (int group = 1; look; ++group) {
        most = crease_fold_layer(estimate, receiver, tap, most, depths.x);
        most = crease_fold_others(estimate, receiver, tap, most, depths);
        look = group < crease_group_count() && depths.w < crease_background;
        if (look)
            depths = crease_fetch_group(tap.texel, group);
    }
    return most;
}
#ifdef __cplusplus
")glsl"
#endif
