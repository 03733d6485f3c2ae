// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
crease_result crease_decode(uvec4 texel);
crease_result crease_weighted(crease_result result, float weight);
crease_result crease_mean(crease_result sum, float weights, float depth);
crease_plane crease_plane_at(vec2 texel, float depth, vec3 normal);
void crease_plane_add(inout crease_result sum, inout float weights, crease_plane plane, ivec2 pixel, ivec2 away,
                      int radius);
#else
__LINE__, R"glsl("
#endif

// A square of pixels.
crease_result crease_evaluate(ivec2 pixel) {
    crease_result own = crease_decode(crease_load_input(pixel));
    if (!(own.depth < 0.99 * crease_background)) // the encoding rounds it
        return own;
    crease_plane plane = crease_plane_at(crease_texel_of_pixel(pixel, crease_divisor), own.depth, own.normal);
    crease_result sum = crease_weighted(own, 0.0);
    float weights = 0.0;
    for (int y = -crease_plane_filter_radius; y <= crease_plane_filter_radius; ++y)
        for (int x = -crease_plane_filter_radius; x <= crease_plane_filter_radius; ++x)
            crease_plane_add(sum, weights, plane, pixel, ivec2(x, y), crease_plane_filter_radius);
    return crease_mean(sum, weights, own.depth);
}
#ifdef __cplusplus
")glsl"
#endif
