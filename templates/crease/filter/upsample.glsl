// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
float crease_depth_at(vec2 texel);
vec3 crease_view_position(vec2 texel, float depth);
crease_result crease_decode(uvec4 texel);
crease_result crease_open_result();
crease_result crease_weighted(crease_result result, float weight);
crease_result crease_sum(crease_result a, crease_result b);
crease_result crease_mean(crease_result sum, float weights, float depth);
float crease_plane_sharpness(float depth);
#else
__LINE__, R"glsl("
#endif

// Each texel of the picture from the four nearest of the smaller one, weighed by distance and by how near it lies to their
// tangent planes: that takes no normal of the picture's own.
crease_result crease_evaluate(ivec2 pixel) {
    vec2 texel = crease_texel_of_pixel(pixel, crease_divisor);
    float depth = crease_depth_at(texel);
    if (!(depth < crease_background))
        return crease_open_result();
    vec3 position = crease_view_position(texel, depth);
    float sharpness = crease_plane_sharpness(depth);
    // The smaller picture's pixel (i, j) stands for the texel crease_texel_of_pixel((i, j)) of this one.
    vec2 between = (vec2(pixel) - float((crease_upsample_factor - 1) / 2)) / float(crease_upsample_factor);
    ivec2 first = ivec2(floor(between));
    vec2 part = between - vec2(first);
    ivec2 last = crease_size(crease_input_divisor) - 1;
    crease_result sum = crease_weighted(crease_open_result(), 0.0);
    vec3 normal = vec3(0.0);
    float weights = 0.0;
    for (int j = 0; j < 2; ++j)
        for (int i = 0; i < 2; ++i) {
            ivec2 at = clamp(first + ivec2(i, j), ivec2(0), last);
            crease_result coarse = crease_decode(crease_load_input(at));
            vec3 coarse_position = crease_view_position(crease_texel_of_pixel(at, crease_input_divisor), coarse.depth);
            float height = min(abs(dot(coarse_position - position, coarse.normal)) * sharpness, 1e6);
            // Where all are of other surfaces, the nearest plane counts.
            float weight = ((i == 0 ? 1.0 - part.x : part.x) * (j == 0 ? 1.0 - part.y : part.y) + 1e-3) *
                max(1.0 - height, 1e-4 / (1.0 + height));
            sum = crease_sum(sum, crease_weighted(coarse, weight));
            normal += weight * coarse.normal;
            weights += weight;
        }
    sum.normal = normalize(normal);
    return crease_mean(sum, weights, depth);
}
#ifdef __cplusplus
")glsl"
#endif
