#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// Each tap looks at all its layers.

crease_contribution crease_fold_groups(crease_estimate estimate, crease_receiver receiver, crease_tap tap,
                                       crease_contribution most, bool more);

crease_contribution crease_fold(crease_estimate estimate, crease_receiver receiver, crease_tap tap) {
    crease_contribution most;
    most.occlusion = -1.0; // less than the first layer's
    return crease_fold_groups(estimate, receiver, tap, most, true);
}
#ifdef __cplusplus
")glsl"
#endif
