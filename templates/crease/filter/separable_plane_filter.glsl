// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
crease_result crease_decode(uvec4 texel);
crease_result crease_weighted(crease_result result, float weight);
crease_result crease_sum(crease_result a, crease_result b);
crease_result crease_mean(crease_result sum, float weights, float depth);
crease_plane crease_plane_at(vec2 texel, float depth, vec3 normal);
float crease_plane_weight(crease_plane plane, vec2 away, float depth, vec3 normal);
#else
__LINE__, R"glsl("
#endif

// A row or a column of pixels, which count by a Gaussian whose standard deviation is 3/4 of the radius, and by the tangent
// plane.
crease_result crease_evaluate(ivec2 pixel) {
    crease_result own = crease_decode(crease_load_input(pixel));
    if (!(own.depth < 0.99 * crease_background)) // the encoding rounds it
        return own;
    vec2 texel = crease_texel_of_pixel(pixel, crease_divisor);
    crease_plane plane = crease_plane_at(texel, own.depth, own.normal);
    ivec2 last = crease_size(crease_divisor) - 1;
    const int radius = crease_separable_plane_filter_radius;
    const float spread = -1.28239 / float(radius * radius); // log2(e) / (2 (3/4)^2)
    crease_result sum = crease_weighted(own, 0.0);
    float weights = 0.0;
    for (int i = -radius; i <= radius; ++i) {
        ivec2 at = crease_separable_plane_filter_axis == 0 ? ivec2(clamp(pixel.x + i, 0, last.x), pixel.y)
                                                           : ivec2(pixel.x, clamp(pixel.y + i, 0, last.y));
        crease_result other = crease_decode(crease_load_input(at));
        vec2 away = crease_texel_of_pixel(at, crease_divisor) - texel;
        float weight = exp2(spread * float(i * i)) * crease_plane_weight(plane, away, other.depth, other.normal);
        sum = crease_sum(sum, crease_weighted(other, weight));
        weights += weight;
    }
    return crease_mean(sum, weights, own.depth);
}
#ifdef __cplusplus
")glsl"
#endif
