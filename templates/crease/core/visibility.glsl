#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// The result of a pixel of the main pass.

float crease_depth_at(vec2 texel);
vec3 crease_view_position(vec2 texel, float depth);
vec3 crease_normal_at(vec2 texel, vec3 position);
crease_receiver crease_receiver_at(ivec2 pixel, vec2 texel, vec3 position, vec3 normal);
crease_gathered crease_gather(crease_receiver receiver);
crease_result crease_conclude(crease_gathered gathered, crease_receiver receiver);
crease_result crease_open();

crease_result crease_evaluate(ivec2 pixel) {
    vec2 texel = crease_texel_of_pixel(pixel, crease_divisor);
    float depth = crease_depth_at(texel);
    if (!(depth > 0.0 && depth < crease_background))
        return crease_open();
    vec3 position = crease_view_position(texel, depth);
    crease_receiver receiver = crease_receiver_at(pixel, texel, position, crease_normal_at(texel, position));
    return crease_conclude(crease_gather(receiver), receiver);
}
#ifdef __cplusplus
")glsl"
#endif
