// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// Three numbers of 11, 11 and 10 bits, from places of the tile that are far apart. From frame to frame they step by R2 and
// the golden ratio, as those of hilbert_r2_noise, which leaves them blue.
vec3 crease_noise(ivec2 pixel) {
    uint texel = crease_load_blue_noise(pixel & 63).x;
    uvec3 share = (uvec3(texel, texel << 11u, texel << 22u) & 0xffe00000u) + uvec3(1048576u, 1048576u, 2097152u) +
        crease_frame * uvec3(3242174889u, 2447445414u, 2654435769u); // fractions of 2^32
    return vec3(share >> 8u) * (1.0 / 16777216.0);
}
#ifdef __cplusplus
")glsl"
#endif
