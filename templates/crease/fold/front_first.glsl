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

crease_contribution crease_fold(crease_estimate estimate, crease_receiver receiver, crease_tap tap) {
    vec3 front = crease_view_position(tap.texel, crease_depth_at(tap.texel));
    crease_contribution most = crease_weigh(estimate, receiver, tap, front);
    vec3 to_front = front - receiver.position;
    float reach = crease_front_reach * crease_radius;
    bool near = dot(to_front, to_front) < reach * reach;
    bool settled =
        near || (crease_front_first_angle != 0 && crease_front_settles(estimate, receiver, tap, front));
    bool more = !settled;
    for (int group = 0; more; ++group) {
        vec4 depths = crease_fetch_group(tap.texel, group);
        more = depths.w < crease_background && group + 1 < crease_group_count();
        // A loop of one round, as a group of invocations leaves a loop where none of them needs it.
        for (bool look = crease_may_occlude(receiver, tap, depths); look; look = false) {
            most = crease_fold_layer(estimate, receiver, tap, most, depths.x);
            most = crease_fold_others(estimate, receiver, tap, most, depths);
        }
    }
    return most;
}
#ifdef __cplusplus
")glsl"
#endif
