#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// Each tap looks at all its layers: stochastic-depth-ao 6.2, Algorithms 7, 8 and 9.

vec4 crease_fetch_group(vec2 texel, int group);
vec3 crease_view_position(vec2 texel, float depth);
crease_contribution crease_weigh(crease_estimate estimate, crease_receiver receiver, crease_tap tap, vec3 position);
crease_contribution crease_fold_others(crease_estimate estimate, crease_receiver receiver, crease_tap tap,
                                       crease_contribution most, vec4 depths);
crease_contribution crease_fold_groups(crease_estimate estimate, crease_receiver receiver, crease_tap tap,
                                       crease_contribution most, int first, bool look);

// The first group; the others are fetched where they are asked for.
struct crease_layers {
    vec4 depths;
};

crease_layers crease_fetch_layers(vec2 texel) {
    return crease_layers(crease_fetch_group(crease_inside(texel) ? texel : crease_first_texel, 0));
}

crease_contribution crease_fold(crease_estimate estimate, crease_receiver receiver, crease_tap tap,
                                crease_layers layers) {
    vec4 depths = layers.depths;
    crease_contribution most = crease_weigh(estimate, receiver, tap, crease_view_position(tap.texel, depths.x));
    most = crease_fold_others(estimate, receiver, tap, most, depths);
    return crease_fold_groups(estimate, receiver, tap, most, 1, depths.w < crease_background);
}
#ifdef __cplusplus
")glsl"
#endif
