// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
float crease_depth_at(vec2 texel);
vec3 crease_view_position(vec2 texel, float depth);
vec3 crease_normal_at(vec2 texel, vec3 position);
crease_receiver crease_make_receiver(ivec2 pixel, vec2 texel, vec3 position, vec3 normal);
crease_result crease_result_of(crease_receiver receiver);
crease_result crease_open_result();
#else
__LINE__, R"glsl("
#endif

// Of the surface in the depth image; background is open.
crease_result crease_evaluate(ivec2 pixel) {
    vec2 texel = crease_texel_of_pixel(pixel, crease_divisor);
    float depth = crease_depth_at(texel);
    if (!(depth > 0.0 && depth < crease_background))
        return crease_open_result();
    vec3 position = crease_view_position(texel, depth);
    return crease_result_of(crease_make_receiver(pixel, texel, position, crease_normal_at(texel, position)));
}
#ifdef __cplusplus
")glsl"
#endif
