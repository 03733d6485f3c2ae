#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// A coin for each sample: stochastic-depth-ao, Algorithm 4.

uvec3 crease_fragment_noise(uint salt);
float crease_unit_float(uint bits);

uint crease_kept_samples(vec3 anchor) {
    uint kept = 0u;
    for (int i = 0; i < crease_stochastic_layers_count; ++i)
        if (crease_unit_float(crease_fragment_noise(uint(i)).x) < crease_opacity)
            kept |= 1u << uint(i);
    return kept;
}
#ifdef __cplusplus
")glsl"
#endif
