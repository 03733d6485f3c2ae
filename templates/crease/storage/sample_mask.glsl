// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
uint crease_kept_samples(vec3 anchor);
#else
__LINE__, R"glsl("
#endif

// Draws a fragment to those samples of a multisampled depth attachment that keep it: stochastic-depth-ao 5.1.
void crease_mask_samples(vec3 anchor) {
    uint kept = crease_kept_samples(anchor);
    if (kept == 0u)
        discard;
    gl_SampleMask[0] = int(kept);
}
#ifdef __cplusplus
")glsl"
#endif
