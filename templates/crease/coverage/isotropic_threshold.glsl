// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
uint crease_kept_by_threshold(vec3 coarse, vec3 fine, float between);
#else
__LINE__, R"glsl("
#endif

// A threshold for each sample that stays on the surface when the camera moves: a hash of the anchor on a grid as wide
// as a texel, between the two nearest powers of two: stochastic-depth-ao 8.2.
uint crease_kept_samples(vec3 anchor) {
    float width = max(length(dFdx(anchor)), length(dFdy(anchor)));
    float level = -log2(max(width, 1.0e-20));
    vec3 coarse = floor(anchor * exp2(floor(level)));
    vec3 fine = floor(anchor * exp2(ceil(level)));
    return crease_kept_by_threshold(coarse, fine, fract(level));
}
#ifdef __cplusplus
")glsl"
#endif
