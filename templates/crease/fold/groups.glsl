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

crease_contribution crease_fold_group(crease_estimate estimate, crease_receiver receiver, crease_tap tap,
                                      crease_contribution most, vec4 depths) {
    most = crease_fold_layer(estimate, receiver, tap, most, depths.x);
    return crease_fold_others(estimate, receiver, tap, most, depths);
}

const int crease_most_groups = 8; // of 32 layers

struct crease_groups {
    vec4 depths[crease_most_groups];
};

// The groups from `first` until `end`, all before any is weighed, so that the waits overlap.
crease_groups crease_fetch_groups(vec2 texel, int first, int end) {
    crease_groups groups;
    crease_unroll for (int group = first; group < end; ++group)
        groups.depths[group] = crease_fetch_group(texel, group);
    return groups;
}

// The groups from `first` until `end`; `look`: whether the first of them may matter, and then whether one after them
// may. The first is weighed without a branch, as where one tap has it those around mostly do.
crease_contribution crease_fold_fetched(crease_estimate estimate, crease_receiver receiver, crease_tap tap,
                                        crease_contribution most, crease_groups groups, int first, int end,
                                        inout bool look) {
    crease_unroll for (int group = first; group < end; ++group) {
        vec4 depths = look ? groups.depths[group] : vec4(crease_background);
        if (group == first || look)
            most = crease_fold_group(estimate, receiver, tap, most, depths);
        look = depths.w < crease_background;
    }
    return most;
}

// The groups from `first` on, where any may matter.
crease_contribution crease_fold_groups(crease_estimate estimate, crease_receiver receiver, crease_tap tap,
                                       crease_contribution most, int first, bool look) {
    if (look) {
        int end = crease_group_count();
        crease_groups groups = crease_fetch_groups(tap.inside ? tap.texel : crease_first_texel, first, end);
        most = crease_fold_fetched(estimate, receiver, tap, most, groups, first, end, look);
    }
    return most;
}
#ifdef __cplusplus
")glsl"
#endif
