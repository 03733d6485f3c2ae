#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// A coin for each sample, by a hash of the fragment's place and the sample's index: stochastic-depth-ao 8.2.

float crease_hash_4d(vec4 v);

uint crease_kept_samples(vec3 anchor) {
    uint kept = 0u;
    float seed = float(crease_frame & 1023u) * 32.0;
    for (int i = 0; i < crease_stochastic_layers_count; ++i)
        if (crease_hash_4d(vec4(gl_FragCoord.xyz, seed + float(i))) < crease_opacity)
            kept |= 1u << uint(i);
    return kept;
}
#ifdef __cplusplus
")glsl"
#endif
