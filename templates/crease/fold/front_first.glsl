#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// The front surface first, and the layers behind it only where they may matter: stochastic-depth-ao 6.3.

float crease_depth_at(vec2 texel);
vec3 crease_view_position(vec2 texel, float depth);
crease_contribution crease_weigh(crease_estimate estimate, crease_receiver receiver, crease_tap tap, vec3 position);
bool crease_front_settles(crease_estimate estimate, crease_receiver receiver, crease_tap tap, vec3 position);
int crease_group_count();
vec4 crease_fetch_group(vec2 texel, int group);
crease_contribution crease_fold_layer(crease_estimate estimate, crease_receiver receiver, crease_tap tap,
                                      crease_contribution most, float depth);
crease_contribution crease_fold_others(crease_estimate estimate, crease_receiver receiver, crease_tap tap,
                                       crease_contribution most, vec4 depths);

// The front one; those behind it are fetched where they are asked for.
struct crease_layers {
    float front;
};

crease_layers crease_fetch_layers(vec2 texel) { return crease_layers(crease_depth_at(texel)); }

crease_contribution crease_fold(crease_estimate estimate, crease_receiver receiver, crease_tap tap,
                                crease_layers layers) {
    vec3 front = crease_view_position(tap.texel, layers.front);
    crease_contribution most = crease_weigh(estimate, receiver, tap, front);
    vec3 to_front = front - receiver.position;
    float reach = crease_front_reach * crease_radius;
    bool near = dot(to_front, to_front) < reach * reach;
    bool look = !near &&
        !(crease_front_first_angle != 0 && crease_front_settles(estimate, receiver, tap, front));
    crease_unroll for (int group = 0; group < crease_group_count(); ++group)
        if (look) {
            vec4 depths = crease_fetch_group(tap.texel, group);
            most = crease_fold_layer(estimate, receiver, tap, most, depths.x);
            most = crease_fold_others(estimate, receiver, tap, most, depths);
            look = depths.w < crease_background;
        }
    return most;
}
#ifdef __cplusplus
")glsl"
#endif
