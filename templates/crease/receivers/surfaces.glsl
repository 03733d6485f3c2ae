// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
crease_surface crease_surface_at(ivec2 texel, int i);
vec3 crease_view_position(vec2 texel, float depth);
vec3 crease_to_eye(vec3 position);
crease_receiver crease_make_receiver(ivec2 pixel, vec2 texel, vec3 position, vec3 normal);
crease_result crease_result_of_surface(crease_receiver receiver, float opacity);
crease_result crease_blend(crease_result before, crease_result own, vec3 color, float share);
crease_result crease_open_result();
crease_result crease_weighted(crease_result result, float weight);
crease_result crease_sum(crease_result a, crease_result b);
#else
__LINE__, R"glsl("
#endif

const int crease_most_receivers = crease_kept_surfaces;

// Less than half of what eight bits tell is seen behind.
const float crease_least_seen = 1.0 / 512.0;

// Of every layer, nearest first, each by how much of it is seen; background is open. Occlusion so counts by the opacity of
// the surface that receives it: equation (1) of a-buffer-ssao 2013.
crease_result crease_evaluate(ivec2 pixel) {
    vec2 texel = crease_texel_of_pixel(pixel, crease_divisor);
    crease_result merged = crease_weighted(crease_open_result(), 0.0);
    float seen = 1.0; // of what lies behind
    for (int i = 0; i < crease_most_receivers && seen > crease_least_seen; ++i) {
        crease_surface surface = crease_surface_at(ivec2(texel), i);
        if (!(surface.depth < crease_background))
            break;
        vec3 position = crease_view_position(texel, surface.depth);
        vec3 normal = dot(surface.normal, crease_to_eye(position)) < 0.0 ? -surface.normal : surface.normal;
        crease_result own =
            crease_result_of_surface(crease_make_receiver(pixel, texel, position, normal), surface.color.a);
        if (i == 0)
            merged = crease_weighted(own, 0.0); // whose depth and normal stay
        merged = crease_blend(merged, own, surface.color.rgb, seen * surface.color.a);
        seen *= 1.0 - surface.color.a;
    }
    return crease_sum(merged, crease_weighted(crease_open_result(), seen));
}
#ifdef __cplusplus
")glsl"
#endif
