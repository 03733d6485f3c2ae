// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
float crease_linear_depth(float device);
uint crease_kept_samples(vec3 anchor);
#else
__LINE__, R"glsl("
#endif

// Draws a fragment to those layers of an array image that keep it, each of which keeps its nearest: positive floats
// are ordered as their bits are. Algorithm 4 of stochastic-depth-ao without multisampling.

// Called by the host's fragment shader, after its own alpha test. `anchor`: the position on the surface, in world or
// object space, which a coverage may hash.
void crease_capture(vec3 anchor) {
    uint bits = floatBitsToUint(crease_linear_depth(gl_FragCoord.z));
    for (uint kept = crease_kept_samples(anchor); kept != 0u; kept &= kept - 1u)
        imageAtomicMin(crease_captured_layers, ivec3(gl_FragCoord.xy, findLSB(kept)), bits);
}
#ifdef __cplusplus
")glsl"
#endif
