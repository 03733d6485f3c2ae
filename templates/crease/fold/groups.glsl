#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// The layer that occludes the most, of a group of four.

int crease_layer_count();
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
#ifdef __cplusplus
")glsl"
#endif
