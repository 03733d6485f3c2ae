#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// One direction of a separable cross-bilateral blur with a depth-slope correction: stochastic-depth-ao 8.1.

crease_result crease_decode(uvec4 texel);
crease_result crease_weighted(crease_result result, float weight);
crease_result crease_sum(crease_result a, crease_result b);
crease_result crease_mean(crease_result sum, float weights, float depth);

// The slope of one side, or where that looks like an edge, the other side's carried on.
float crease_bilateral_slope(float own, float other, float tightness) {
    return abs(own) * tightness > 1.0 && abs(own) > 2.0 * abs(other) ? -other : own;
}

crease_result crease_evaluate(ivec2 pixel) {
    vec2 scale = 1.0 / vec2(textureSize(crease_input, 0));
    vec2 last = vec2(crease_size(crease_divisor));
    vec2 axis = vec2(crease_bilateral_axis == 0, crease_bilateral_axis == 1);
    vec2 centre = vec2(pixel) + 0.5;
    crease_result own = crease_decode(textureLod(crease_input, centre * scale, 0.0));
    if (!(own.depth < 0.99 * crease_background)) // the encoding rounds it
        return own;
    float tightness = crease_sharpness / max(crease_radius, 1e-20);
    const float spread = 2.0 / float(crease_bilateral_radius * crease_bilateral_radius);
    crease_result sum = own;
    float weights = 1.0;
    float slope_before = 0.0, slope_after = 0.0;
    for (int i = 1; i <= crease_bilateral_radius; ++i) {
        float away = float(i);
        vec2 at_before = centre - axis * away, at_after = centre + axis * away;
        crease_result before = crease_decode(textureLod(crease_input, at_before * scale, 0.0));
        crease_result after = crease_decode(textureLod(crease_input, at_after * scale, 0.0));
        float apart_before = before.depth - own.depth, apart_after = after.depth - own.depth;
        if (i == 1) {
            slope_before = crease_bilateral_slope(apart_before, apart_after, tightness);
            slope_after = crease_bilateral_slope(apart_after, apart_before, tightness);
        }
        apart_before = (apart_before - slope_before * away) * tightness;
        apart_after = (apart_after - slope_after * away) * tightness;
        float weight_before = exp2(-spread * away * away - apart_before * apart_before);
        float weight_after = exp2(-spread * away * away - apart_after * apart_after);
        weight_before = dot(at_before, axis) > 0.0 ? weight_before : 0.0;
        weight_after = dot(last - at_after, axis) > 0.0 ? weight_after : 0.0;
        sum = crease_sum(sum, crease_weighted(before, weight_before));
        sum = crease_sum(sum, crease_weighted(after, weight_after));
        weights += weight_before + weight_after;
    }
    return crease_mean(sum, weights, own.depth);
}
#ifdef __cplusplus
")glsl"
#endif
