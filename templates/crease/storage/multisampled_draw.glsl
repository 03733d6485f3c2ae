// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
void crease_mask_samples(vec3 anchor);
#else
__LINE__, R"glsl("
#endif

// Samples lie anywhere in the texel, and all have the depth at its centre: stochastic-depth-ao 6.1.

// Called by the host's fragment shader, after its own alpha test. `anchor`: the position on the surface, in world or
// object space, which a coverage may hash.
void crease_capture(vec3 anchor) {
    crease_mask_samples(anchor);
    gl_FragDepth = gl_FragCoord.z;
}
#ifdef __cplusplus
")glsl"
#endif
