// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
vec3 crease_view_position(vec2 texel, float depth);
crease_result crease_decode(uvec4 texel);
crease_result crease_weighted(crease_result result, float weight);
crease_result crease_sum(crease_result a, crease_result b);
crease_result crease_mean(crease_result sum, float weights, float depth);
crease_plane crease_plane_at(vec3 position, vec3 normal);
float crease_plane_weight(crease_plane plane, vec3 position, vec3 normal);
#else
__LINE__, R"glsl("
#endif

vec3 crease_plane_filter_position(ivec2 pixel, float depth) {
    return crease_view_position(crease_texel_of_pixel(pixel, crease_divisor), depth);
}

crease_result crease_evaluate(ivec2 pixel) {
    crease_result own = crease_decode(crease_load_input(pixel));
    if (!(own.depth < 0.99 * crease_background)) // the encoding rounds it
        return own;
    crease_plane plane = crease_plane_at(crease_plane_filter_position(pixel, own.depth), own.normal);
    ivec2 last = crease_size(crease_divisor) - 1;
    ivec2 step = crease_separable_plane_filter_axis == 0 ? ivec2(1, 0) : ivec2(0, 1);
    crease_result sum = own;
    float weights = 1.0;
    crease_unroll for (int i = -crease_separable_plane_filter_radius; i <= crease_separable_plane_filter_radius; ++i) {
            ivec2 at = pixel + i * step;
            ivec2 inside = clamp(at, ivec2(0), last);
            crease_result other = crease_decode(crease_load_input(inside));
            float weight = exp2(-0.3205989 * float(i * i)) *
                crease_plane_weight(plane, crease_plane_filter_position(inside, other.depth), other.normal);
            weight = at == inside && at != pixel ? weight : 0.0;
            sum = crease_sum(sum, crease_weighted(other, weight));
            weights += weight;
        }
    return crease_mean(sum, weights, own.depth);
}
#ifdef __cplusplus
")glsl"
#endif
