#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// Draws a fragment to those samples of a multisampled depth attachment that keep it. All samples lie at the centre of
// the texel, so no depth has to be written, and the device may test depths before it shades: stochastic-depth-ao 5.1.

uint crease_kept_samples(vec3 anchor);

// In the fragment shader of the geometry pass, after its own alpha test. `anchor`: the position on the surface, in
// world or object space; what samples the layers may hash it.
void crease_capture(vec3 anchor) {
    uint kept = crease_kept_samples(anchor);
    if (kept == 0u)
        discard;
    gl_SampleMask[0] = int(kept);
}
#ifdef __cplusplus
")glsl"
#endif
