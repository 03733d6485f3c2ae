// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
crease_result crease_decode(uvec4 texel);
crease_result crease_weighted(crease_result result, float weight);
crease_result crease_sum(crease_result a, crease_result b);
crease_result crease_mean(crease_result sum, float weights, float depth);
#else
__LINE__, R"glsl("
#endif

// One direction of a separable cross-bilateral blur with a depth-slope correction: stochastic-depth-ao 8.1.

// The slope of one side, or where that looks like an edge, that of the other side, extrapolated.
float crease_bilateral_slope(float own, float other, float tightness) {
    return abs(own) * tightness > 1.0 && abs(own) > 2.0 * abs(other) ? -other : own;
}

crease_result crease_evaluate(ivec2 pixel) {
    ivec2 step = ivec2(crease_bilateral_axis == 0, crease_bilateral_axis == 1);
    vec2 axis = vec2(step);
    ivec2 last = crease_size(crease_divisor) - 1;
    // All are fetched before any is weighed, so that the waits overlap.
    uvec4 texels_before[crease_bilateral_radius];
    uvec4 texels_after[crease_bilateral_radius];
    crease_result own = crease_decode(crease_load_input(pixel));
    for (int i = 0; i < crease_bilateral_radius; ++i) {
        texels_before[i] = crease_load_input(max(pixel - step * (i + 1), ivec2(0)));
        texels_after[i] = crease_load_input(min(pixel + step * (i + 1), last));
    }
    float tightness = crease_bilateral_sharpness / max(crease_radius, 1e-20);
    float rise_before = crease_decode(texels_before[0]).depth - own.depth;
    float rise_after = crease_decode(texels_after[0]).depth - own.depth;
    float slope_before = crease_bilateral_slope(rise_before, rise_after, tightness);
    float slope_after = crease_bilateral_slope(rise_after, rise_before, tightness);
    float room_before = dot(vec2(pixel), axis);
    float room_after = dot(vec2(crease_size(crease_divisor) - 1), axis) - room_before;
    const float spread = 2.0 / float(crease_bilateral_radius * crease_bilateral_radius);
    crease_result sum = own;
    float weights = 1.0;
    for (int i = 0; i < crease_bilateral_radius; ++i) {
        float away = float(i + 1);
        crease_result before = crease_decode(texels_before[i]), after = crease_decode(texels_after[i]);
        float apart_before = (before.depth - own.depth - slope_before * away) * tightness;
        float apart_after = (after.depth - own.depth - slope_after * away) * tightness;
        float weight_before = exp2(-spread * away * away - apart_before * apart_before);
        float weight_after = exp2(-spread * away * away - apart_after * apart_after);
        weight_before = room_before < away ? 0.0 : weight_before;
        weight_after = room_after < away ? 0.0 : weight_after;
        sum = crease_sum(sum, crease_sum(crease_weighted(before, weight_before), crease_weighted(after, weight_after)));
        weights += weight_before + weight_after;
    }
    if (!(own.depth < 0.99 * crease_background)) // the encoding rounds it
        return own;
    return crease_mean(sum, weights, own.depth);
}
#ifdef __cplusplus
")glsl"
#endif
