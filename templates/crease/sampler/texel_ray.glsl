// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
vec3 crease_view_position(vec2 texel, float depth);
#else
__LINE__, R"glsl("
#endif

// The ray of a texel by the receiver: start + t * ray from it, where t counts depth and is 0 where the receiver is.
// Differences are of rays alone, as those of positions keep nothing of a radius that is small beside the distance.
void crease_texel_ray(crease_receiver receiver, vec2 texel, out vec3 start, out vec3 ray) {
    vec3 eye = crease_view_position(texel, 0.0), own_eye = crease_view_position(receiver.texel, 0.0);
    vec3 own_ray = crease_view_position(receiver.texel, 1.0) - own_eye;
    ray = crease_view_position(texel, 1.0) - eye;
    start = (eye - own_eye) - (ray - own_ray) * receiver.position.z;
}
#ifdef __cplusplus
")glsl"
#endif
