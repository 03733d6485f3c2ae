#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// The layer that occludes the most, of groups of four.

int crease_layer_count();
int crease_group_count();
vec4 crease_fetch_group(vec2 texel, int group);
vec3 crease_view_position(vec2 texel, float depth);
crease_contribution crease_weigh(crease_estimate estimate, crease_receiver receiver, crease_tap tap, vec3 position);

crease_contribution crease_fold_layer(crease_estimate estimate, crease_receiver receiver, crease_tap tap,
                                      crease_contribution most, float depth) {
    crease_contribution other = crease_weigh(estimate, receiver, tap, crease_view_position(tap.texel, depth));
    if (other.occlusion > most.occlusion)
        most = other;
    return most;
}

// The layers of a group after its first; written out, as the group is in registers.
crease_contribution crease_fold_others(crease_estimate estimate, crease_receiver receiver, crease_tap tap,
                                       crease_contribution most, vec4 depths) {
    if (crease_layer_count() > 1)
        most = crease_fold_layer(estimate, receiver, tap, most, depths.y);
    if (crease_layer_count() > 2)
        most = crease_fold_layer(estimate, receiver, tap, most, depths.z);
    if (crease_layer_count() > 3)
        most = crease_fold_layer(estimate, receiver, tap, most, depths.w);
    return most;
}

const int crease_most_groups = 8; // of 32 layers

// The groups from `first` on, where any may matter: all are fetched before any is weighed, so that the waits overlap.
crease_contribution crease_fold_groups(crease_estimate estimate, crease_receiver receiver, crease_tap tap,
                                       crease_contribution most, int first, bool look) {
    vec4 groups[crease_most_groups];
    if (look) {
        crease_unroll for (int group = first; group < crease_group_count(); ++group)
            groups[group] = crease_fetch_group(tap.texel, group);
    }
    crease_unroll for (int group = first; group < crease_group_count(); ++group)
        if (look) {
            most = crease_fold_layer(estimate, receiver, tap, most, groups[group].x);
            most = crease_fold_others(estimate, receiver, tap, most, groups[group]);
            look = groups[group].w < crease_background;
        }
    return most;
}
#ifdef __cplusplus
")glsl"
#endif
