#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// One direction of a separable cross-bilateral blur with a depth-slope correction: stochastic-depth-ao 8.1.

crease_result crease_decode(uvec4 texel);

crease_result crease_evaluate(ivec2 pixel) {
    ivec2 size = crease_size(crease_divisor);
    vec2 scale = 1.0 / vec2(textureSize(crease_input, 0));
    vec2 axis = vec2(crease_bilateral_axis == 0, crease_bilateral_axis == 1);
    vec2 texel = vec2(pixel) + 0.5;
    crease_result centre = crease_decode(textureLod(crease_input, texel * scale, 0.0));
    if (!(centre.depth < crease_far_depth * 0.99))
        return centre;
    float tightness = crease_sharpness / max(crease_radius, 1e-20);
    const float spread = 2.0 / float(crease_bilateral_radius * crease_bilateral_radius);
    float sum = centre.visibility;
    float weights = 1.0;
    for (int side = -1; side <= 1; side += 2) {
        float slope = 0.0;
        for (int i = 1; i <= crease_bilateral_radius; ++i) {
            vec2 at = texel + axis * float(side * i);
            crease_result other = crease_decode(textureLod(crease_input, at * scale, 0.0));
            float apart = other.depth - centre.depth;
            if (i == 1)
                slope = apart;
            apart = (apart - slope * float(i)) * tightness;
            float weight = exp2(-spread * float(i * i) - apart * apart);
            weight = all(greaterThan(at, vec2(0.0))) && all(lessThan(at, vec2(size))) ? weight : 0.0;
            sum += other.visibility * weight;
            weights += weight;
        }
    }
    return crease_result(sum / weights, centre.depth);
}
#ifdef __cplusplus
")glsl"
#endif
