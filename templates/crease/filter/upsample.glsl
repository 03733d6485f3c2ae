#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// Each texel of the picture from the four nearest of the smaller one, weighed by distance and by likeness of depth.

float crease_depth_at(vec2 texel);
crease_result crease_decode(uvec4 texel);
crease_result crease_open();
crease_result crease_weighted(crease_result result, float weight);
crease_result crease_sum(crease_result a, crease_result b);
crease_result crease_mean(crease_result sum, float weights, float depth);

crease_result crease_evaluate(ivec2 pixel) {
    vec2 texel = crease_texel_of_pixel(pixel, crease_divisor);
    float depth = crease_depth_at(texel);
    if (!(depth < crease_background))
        return crease_open();
    // The smaller picture's pixel (i, j) stands for the texel crease_texel_of_pixel((i, j)) of this one.
    vec2 position = (vec2(pixel) - float((crease_upsample_factor - 1) / 2)) / float(crease_upsample_factor);
    ivec2 first = ivec2(floor(position));
    vec2 part = position - vec2(first);
    ivec2 last = crease_size(crease_input_divisor) - 1;
    float tightness = crease_sharpness / max(crease_radius, 1e-20);
    crease_result sum = crease_weighted(crease_open(), 0.0);
    float weights = 0.0;
    for (int j = 0; j < 2; ++j)
        for (int i = 0; i < 2; ++i) {
            crease_result coarse =
                crease_decode(imageLoad(crease_input, clamp(first + ivec2(i, j), ivec2(0), last)));
            float apart = (coarse.depth - depth) * tightness;
            float weight = (i == 0 ? 1.0 - part.x : part.x) * (j == 0 ? 1.0 - part.y : part.y);
            weight = (weight + 1e-3) / (1.0 + apart * apart);
            sum = crease_sum(sum, crease_weighted(coarse, weight));
            weights += weight;
        }
    return crease_mean(sum, weights, depth);
}
#ifdef __cplusplus
")glsl"
#endif
