#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// A threshold in (0, 1] out of two hashes and how far between them: by itself the mix is not evenly distributed, so it
// goes through its own cumulative distribution. Wyman and McGuire, Hashed Alpha Testing, 2017.
float crease_threshold_of(vec2 hashes, float between) {
    float mixed = mix(hashes.x, hashes.y, between);
    float least = min(between, 1.0 - between);
    float low = mixed * mixed / (2.0 * least * (1.0 - least));
    float middle = (mixed - 0.5 * least) / (1.0 - least);
    float high = 1.0 - (1.0 - mixed) * (1.0 - mixed) / (2.0 * least * (1.0 - least));
    float even = mixed < least ? low : mixed < 1.0 - least ? middle : high;
    return clamp(even, 1.0e-6, 1.0);
}
#ifdef __cplusplus
")glsl"
#endif
