// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// What is left of a contribution where the layer has an opacity: equation (1) of a-buffer-ssao 2013. Of 1 all is, and of 0
// nothing.
crease_contribution crease_fade(crease_march march, crease_receiver receiver, crease_tap tap,
                                crease_contribution contribution, float opacity) {
    contribution.occlusion *= opacity;
    return contribution;
}
#ifdef __cplusplus
")glsl"
#endif
