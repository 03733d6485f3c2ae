// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// How far along a Hilbert curve, which fills tiles of 64 x 64 pixels, a pixel lies.
uint crease_hilbert_r2_noise_index(uvec2 pixel) {
    uint index = 0u;
    for (uint half_side = 32u; half_side > 0u; half_side /= 2u) {
        uvec2 quarter = uvec2(notEqual(pixel & half_side, uvec2(0u)));
        index += half_side * half_side * (3u * quarter.x ^ quarter.y);
        pixel = quarter == uvec2(1u, 0u) ? ~pixel : pixel;
        pixel = quarter.y == 0u ? pixel.yx : pixel;
    }
    return index;
}

// Along the curve the first two numbers step by R2, powers of 0.7548777, and the third by the golden ratio: Roberts 2018,
// The Unreasonable Effectiveness of Quasirandom Sequences. In each frame a pixel is 1140 further on, which divides [0, 1)
// evenly for few frames as for many.
vec3 crease_noise(ivec2 pixel) {
    uint place = crease_hilbert_r2_noise_index(uvec2(pixel)) + 1140u * crease_frame;
    uvec3 share = place * uvec3(3242174889u, 2447445414u, 2654435769u) + 2147483648u; // fractions of 2^32
    return vec3(share >> 8u) * (1.0 / 16777216.0);
}
#ifdef __cplusplus
")glsl"
#endif
