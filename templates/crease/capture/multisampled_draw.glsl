#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// Draws a fragment to those samples of a multisampled depth attachment that keep it, with the depth at the centre of
// the texel: stochastic-depth-ao 5.1 and 6.1.

uint crease_kept_samples(vec3 anchor);

// In the fragment shader of the geometry pass, after its own alpha test. `anchor`: the position on the surface, in
// world or object space; what samples the layers may hash it.
void crease_capture(vec3 anchor) {
    uint kept = crease_kept_samples(anchor);
    if (kept == 0u)
        discard;
    gl_SampleMask[0] = int(kept);
    gl_FragDepth = gl_FragCoord.z;
}
#ifdef __cplusplus
")glsl"
#endif
