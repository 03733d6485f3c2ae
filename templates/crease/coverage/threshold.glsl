// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
int crease_sample_count();
float crease_hash_4d(vec4 v);
#else
__LINE__, R"glsl("
#endif

// A threshold in (0, 1] from two hashes that are mixed by `between`. The mix is not uniform, so it goes through its own
// cumulative distribution: Wyman and McGuire, Hashed Alpha Testing, 2017.
float crease_threshold_of(vec2 hashes, float between) {
    float mixed = mix(hashes.x, hashes.y, between);
    float least = min(between, 1.0 - between);
    float low = mixed * mixed / (2.0 * least * (1.0 - least));
    float middle = (mixed - 0.5 * least) / (1.0 - least);
    float high = 1.0 - (1.0 - mixed) * (1.0 - mixed) / (2.0 * least * (1.0 - least));
    float even = mixed < least ? low : mixed < 1.0 - least ? middle : high;
    return clamp(even, 1.0e-6, 1.0);
}

// The samples that keep a fragment whose anchor lies in these cells of the coarse and the fine grid.
uint crease_kept_by_threshold(vec3 coarse, vec3 fine, float between) {
    uint kept = 0u;
    float seed = float(crease_frame & 1023u) * 32.0;
    for (int i = 0; i < crease_sample_count(); ++i) {
        vec2 hashes = vec2(crease_hash_4d(vec4(coarse, seed + float(i))), crease_hash_4d(vec4(fine, seed + float(i))));
        if (crease_threshold_of(hashes, between) <= crease_opacity)
            kept |= 1u << uint(i);
    }
    return kept;
}
#ifdef __cplusplus
")glsl"
#endif
