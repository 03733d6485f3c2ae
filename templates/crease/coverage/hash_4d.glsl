// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
int crease_sample_count();
float crease_hash_4d(vec4 v);
#else
__LINE__, R"glsl("
#endif

// A coin for each sample, by a hash of the fragment's place and the sample's index: stochastic-depth-ao 8.2.
uint crease_kept_samples(vec3 anchor) {
    uint kept = 0u;
    float seed = float(crease_frame & 1023u) * 32.0;
    for (int i = 0; i < crease_sample_count(); ++i)
        if (crease_hash_4d(vec4(gl_FragCoord.xyz, seed + float(i))) < crease_opacity)
            kept |= 1u << uint(i);
    return kept;
}
#ifdef __cplusplus
")glsl"
#endif
