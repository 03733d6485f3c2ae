#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// Each tap looks at all its layers: stochastic-depth-ao 6.2, Algorithms 7, 8 and 9.

int crease_group_count();
vec3 crease_view_position(vec2 texel, float depth);
crease_contribution crease_weigh(crease_estimate estimate, crease_receiver receiver, crease_tap tap, vec3 position);
crease_contribution crease_fold_others(crease_estimate estimate, crease_receiver receiver, crease_tap tap,
                                       crease_contribution most, vec4 depths);
crease_groups crease_fetch_groups(vec2 texel, int first, int end);
crease_contribution crease_fold_fetched(crease_estimate estimate, crease_receiver receiver, crease_tap tap,
                                        crease_contribution most, crease_groups groups, int first, int end,
                                        inout bool look);
crease_contribution crease_fold_groups(crease_estimate estimate, crease_receiver receiver, crease_tap tap,
                                       crease_contribution most, int first, bool look);

const int crease_most_asked = 4;

// Groups that are fetched before it is known whether they are there; the others where they are asked for.
int crease_asked() { return min(crease_group_count(), crease_most_asked); }

struct crease_layers {
    crease_groups groups;
};

crease_layers crease_fetch_layers(vec2 texel) {
    return crease_layers(
        crease_fetch_groups(crease_inside(texel) ? texel : crease_first_texel, 0, crease_asked()));
}

crease_contribution crease_fold(crease_estimate estimate, crease_receiver receiver, crease_tap tap,
                                crease_layers layers) {
    vec4 depths = layers.groups.depths[0];
    crease_contribution most = crease_weigh(estimate, receiver, tap, crease_view_position(tap.texel, depths.x));
    most = crease_fold_others(estimate, receiver, tap, most, depths);
    bool look = depths.w < crease_background;
    most = crease_fold_fetched(estimate, receiver, tap, most, layers.groups, 1, crease_asked(), look);
    return crease_fold_groups(estimate, receiver, tap, most, crease_most_asked, look);
}
#ifdef __cplusplus
")glsl"
#endif
