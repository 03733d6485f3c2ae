// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
uint crease_kept_by_threshold(vec3 coarse, vec3 fine, float between);
#else
__LINE__, R"glsl("
#endif

// The same with a grid that follows the texel's footprint along each axis, so that surfaces seen at a grazing angle
// keep noise as fine as a texel: stochastic-depth-ao 8.2.
uint crease_kept_samples(vec3 anchor) {
    vec3 width = max(abs(dFdx(anchor)), abs(dFdy(anchor)));
    // Along an axis that the surface is perpendicular to the footprint is next to 0: cells are no smaller than a 64th
    // of the widest, as floats cannot count smaller ones.
    float greatest = max(max(width.x, width.y), max(width.z, 1.0e-20));
    vec3 level = log2(0.70710678 / max(width, vec3(greatest / 64.0)));
    vec3 coarse = floor(anchor * exp2(floor(level)));
    vec3 fine = floor(anchor * exp2(ceil(level)));
    vec2 corners = vec2(length(fract(level)), length(1.0 - fract(level)));
    float between = corners.x / (corners.x + corners.y);
    return crease_kept_by_threshold(coarse, fine, between);
}
#ifdef __cplusplus
")glsl"
#endif
