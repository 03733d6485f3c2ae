#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// A threshold for each sample that stays on the surface when the camera moves: a hash of the anchor on a grid as wide
// as a texel, between the two nearest powers of two: stochastic-depth-ao 8.2.

float crease_hash_4d(vec4 v);
float crease_threshold_of(vec2 hashes, float between);

uint crease_kept_samples(vec3 anchor) {
    float width = max(length(dFdx(anchor)), length(dFdy(anchor)));
    float level = -log2(max(width, 1.0e-20));
    vec3 coarse = floor(anchor * exp2(floor(level)));
    vec3 fine = floor(anchor * exp2(ceil(level)));
    uint kept = 0u;
    float seed = float(crease_frame & 1023u) * 32.0;
    for (int i = 0; i < crease_stochastic_layers_count; ++i) {
        vec2 hashes = vec2(crease_hash_4d(vec4(coarse, seed + float(i))), crease_hash_4d(vec4(fine, seed + float(i))));
        if (crease_threshold_of(hashes, fract(level)) <= crease_opacity)
            kept |= 1u << uint(i);
    }
    return kept;
}
#ifdef __cplusplus
")glsl"
#endif
