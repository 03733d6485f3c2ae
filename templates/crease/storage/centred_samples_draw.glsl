// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
void crease_mask_samples(vec3 anchor);
#else
__LINE__, R"glsl("
#endif

// All samples lie at the centre of the texel, so no depth has to be written, and the device may test depths before it
// shades: stochastic-depth-ao 6.1.

// Called by the host's fragment shader, after its own alpha test. `anchor`: the position on the surface, in world or
// object space, which a coverage may hash.
void crease_capture(vec3 anchor) { crease_mask_samples(anchor); }
#ifdef __cplusplus
")glsl"
#endif
