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

// The surface in the depth image; false for background.
bool crease_receive(ivec2 pixel, out crease_receiver receiver) {
    vec2 texel = crease_texel_of_pixel(pixel, crease_divisor);
    float depth = crease_depth_at(texel);
    if (!(depth > 0.0 && depth < crease_background))
        return false;
    vec3 position = crease_view_position(texel, depth);
    receiver = crease_make_receiver(pixel, texel, position, crease_normal_at(texel, position));
    return true;
}

crease_result crease_evaluate(ivec2 pixel) {
    crease_receiver receiver;
    return crease_receive(pixel, receiver) ? crease_result_of(receiver) : crease_open_result();
}
#ifdef __cplusplus
")glsl"
#endif
