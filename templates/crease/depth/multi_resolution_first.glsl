// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
float crease_depth_at(vec2 texel);
vec3 crease_view_position(vec2 texel, float depth);
vec3 crease_normal_at(vec2 texel, vec3 position);
uint crease_multi_resolution_pack(vec3 normal);
uvec4 crease_halved(uvec4 a, uvec4 b, uvec4 c, uvec4 d);
#else
__LINE__, R"glsl("
#endif

// The picture of half the size, of the depth image.
uvec4 crease_multi_resolution_texel(ivec2 at) {
    vec2 texel = min(vec2(at), crease_depth_size() - 1.0);
    float depth = crease_depth_at(texel);
    bool there = depth > 0.0 && depth < crease_background;
    vec3 position = crease_view_position(texel, there ? depth : crease_background);
    return uvec4(floatBitsToUint(position), crease_multi_resolution_pack(crease_normal_at(texel, position)));
}

void crease_build(ivec2 texel) {
    ivec2 first = 2 * texel;
    imageStore(crease_resolutions, texel,
               crease_halved(crease_multi_resolution_texel(first), crease_multi_resolution_texel(first + ivec2(1, 0)),
                             crease_multi_resolution_texel(first + ivec2(0, 1)),
                             crease_multi_resolution_texel(first + ivec2(1, 1))));
}
#ifdef __cplusplus
")glsl"
#endif
