// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// Three numbers in [0, 1) that differ from pixel to pixel and from frame to frame.
uvec3 crease_hashed_noise_mix(uvec3 v) {
    v = v * 1664525u + 1013904223u;
    v += v.yzx * v.zxy;
    v ^= v >> 16u;
    v += v.yzx * v.zxy;
    return v;
}

vec3 crease_noise(ivec2 pixel) {
    return vec3(crease_hashed_noise_mix(uvec3(uvec2(pixel), crease_frame)) >> 8u) * (1.0 / 16777216.0);
}
#ifdef __cplusplus
")glsl"
#endif
