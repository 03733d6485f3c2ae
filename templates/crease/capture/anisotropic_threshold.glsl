#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// The same with a grid that follows the texel's footprint along each axis, so that surfaces seen at a grazing angle
// keep noise as fine as a texel: stochastic-depth-ao 8.2.

float crease_hash_4d(vec4 v);
float crease_threshold_of(vec2 hashes, float between);

uint crease_kept_samples(vec3 anchor) {
    vec3 width = max(abs(dFdx(anchor)), abs(dFdy(anchor)));
    vec3 level = log2(0.70710678 / max(width, vec3(1.0e-20)));
    vec3 coarse = floor(anchor * exp2(floor(level)));
    vec3 fine = floor(anchor * exp2(ceil(level)));
    vec2 corners = vec2(length(fract(level)), length(1.0 - fract(level)));
    float between = corners.x / (corners.x + corners.y);
    uint kept = 0u;
    float seed = float(crease_frame & 1023u) * 32.0;
    for (int i = 0; i < crease_stochastic_layers_count; ++i) {
        vec2 hashes = vec2(crease_hash_4d(vec4(coarse, seed + float(i))), crease_hash_4d(vec4(fine, seed + float(i))));
        if (crease_threshold_of(hashes, between) <= crease_opacity)
            kept |= 1u << uint(i);
    }
    return kept;
}
#ifdef __cplusplus
")glsl"
#endif
