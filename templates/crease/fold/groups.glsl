#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// The layer of a tap that occludes the most, of groups of four that end where the first is absent:
// stochastic-depth-ao 6.2, Algorithms 7, 8 and 9.

int crease_group_count();
vec4 crease_fetch_group(vec2 texel, int group);
vec3 crease_view_position(vec2 texel, float depth);
crease_contribution crease_weigh(crease_estimate estimate, crease_receiver receiver, crease_tap tap, vec3 position);

// `most`: of what was weighed before; `more`: whether to look at the groups at all.
crease_contribution crease_fold_groups(crease_estimate estimate, crease_receiver receiver, crease_tap tap,
                                       crease_contribution most, bool more) {
    for (int group = 0; more; ++group) {
        vec4 depths = crease_fetch_group(tap.texel, group);
        more = depths.w < crease_background && group + 1 < crease_group_count();
        do {
            crease_contribution other =
                crease_weigh(estimate, receiver, tap, crease_view_position(tap.texel, depths.x));
            if (other.occlusion > most.occlusion)
                most = other;
            depths = vec4(depths.yzw, crease_background);
        } while (depths.x < crease_background);
    }
    return most;
}
#ifdef __cplusplus
")glsl"
#endif
