// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
float crease_depth_at(vec2 texel);
vec3 crease_view_position(vec2 texel, float depth);
vec3 crease_normal_at(vec2 texel, vec3 position);
crease_result crease_decode(uvec4 texel);
crease_result crease_open_result();
crease_result crease_weighted(crease_result result, float weight);
crease_result crease_sum(crease_result a, crease_result b);
crease_result crease_mean(crease_result sum, float weights, float depth);
#else
__LINE__, R"glsl("
#endif

// Each texel of the picture from the four nearest of the smaller one, weighed by distance and by how near they lie to
// the texel's tangent plane, so that a slanted surface does not fall into steps. Normals are no weight: near a crease
// they would leave the few samples of one side, whose noise shows.
crease_result crease_evaluate(ivec2 pixel) {
    vec2 texel = crease_texel_of_pixel(pixel, crease_divisor);
    float depth = crease_depth_at(texel);
    if (!(depth < crease_background))
        return crease_open_result();
    vec3 position = crease_view_position(texel, depth);
    vec3 normal = crease_normal_at(texel, position);
    // The smaller picture's pixel (i, j) stands for the texel crease_texel_of_pixel((i, j)) of this one.
    vec2 between = (vec2(pixel) - float((crease_upsample_factor - 1) / 2)) / float(crease_upsample_factor);
    ivec2 first = ivec2(floor(between));
    vec2 part = between - vec2(first);
    ivec2 last = crease_size(crease_input_divisor) - 1;
    float tightness = crease_upsample_sharpness / max(crease_radius, 1e-20);
    crease_result sum = crease_weighted(crease_open_result(), 0.0);
    float weights = 0.0;
    for (int j = 0; j < 2; ++j)
        for (int i = 0; i < 2; ++i) {
            ivec2 at = clamp(first + ivec2(i, j), ivec2(0), last);
            crease_result coarse = crease_decode(crease_load_input(at));
            vec2 coarse_texel = crease_texel_of_pixel(at, crease_input_divisor);
            vec3 coarse_position = crease_view_position(coarse_texel, coarse.depth);
            float apart = dot(coarse_position - position, normal) * tightness;
            float weight = (i == 0 ? 1.0 - part.x : part.x) * (j == 0 ? 1.0 - part.y : part.y) + 1e-3;
            weight /= 1.0 + apart * apart;
            sum = crease_sum(sum, crease_weighted(coarse, weight));
            weights += weight;
        }
    return crease_mean(sum, weights, depth);
}
#ifdef __cplusplus
")glsl"
#endif
