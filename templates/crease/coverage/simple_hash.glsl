// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
int crease_sample_count();
uvec3 crease_fragment_noise(uint salt);
float crease_unit_float(uint bits);
#else
__LINE__, R"glsl("
#endif

// A coin for each sample: stochastic-depth-ao, Algorithm 4.
uint crease_kept_samples(vec3 anchor) {
    uint kept = 0u;
    for (int i = 0; i < crease_sample_count(); ++i)
        if (crease_unit_float(crease_fragment_noise(uint(i)).x) < crease_opacity)
            kept |= 1u << uint(i);
    return kept;
}
#ifdef __cplusplus
")glsl"
#endif
