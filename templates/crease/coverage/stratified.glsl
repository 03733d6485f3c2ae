// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
int crease_sample_count();
uvec3 crease_fragment_noise(uint salt);
float crease_unit_float(uint bits);
#else
__LINE__, R"glsl("
#endif

// A random subset of floor(opacity S + xi) of the samples: stochastic-depth-ao, Algorithm 5. More than 16 samples are
// drawn in two halves.

// The subsets stand in order of their size; the last row says where each size begins.
uint crease_stratified_subset(int index) {
    return texelFetch(crease_subsets, ivec2(index & 255, index >> 8), 0).x;
}

uint crease_stratified_half(int samples, uint salt) {
    uvec3 noise = crease_fragment_noise(salt);
    int kept = int(crease_opacity * float(samples) + crease_unit_float(noise.x));
    if (kept == 0 || kept >= samples)
        return kept == 0 ? 0u : (1u << uint(samples)) - 1u;
    int first = int(crease_stratified_subset(65536 + kept));
    int after = int(crease_stratified_subset(65536 + kept + 1));
    return crease_stratified_subset(first + int(crease_unit_float(noise.y) * float(after - first)));
}

uint crease_kept_samples(vec3 anchor) {
    uint kept = crease_stratified_half(min(crease_sample_count(), 16), 0u);
    if (crease_sample_count() > 16)
        kept |= crease_stratified_half(16, 1u) << 16u;
    return crease_sample_count() == 32 ? kept : kept & ((1u << uint(crease_sample_count())) - 1u);
}
#ifdef __cplusplus
")glsl"
#endif
