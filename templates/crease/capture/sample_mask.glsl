#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// Draws a fragment to those samples of a multisampled depth attachment that keep it: stochastic-depth-ao 5.1.

uint crease_kept_samples(vec3 anchor);

void crease_mask_samples(vec3 anchor) {
    uint kept = crease_kept_samples(anchor);
    if (kept == 0u)
        discard;
    gl_SampleMask[0] = int(kept);
}
#ifdef __cplusplus
")glsl"
#endif
