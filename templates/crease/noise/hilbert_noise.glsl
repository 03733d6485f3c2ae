// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// How far along a Hilbert curve, which fills tiles of 64 x 64 pixels, a pixel lies.
uint crease_hilbert_noise_index(uvec2 pixel) {
    uint index = 0u;
    for (uint half_side = 32u; half_side > 0u; half_side /= 2u) {
        uvec2 quarter = uvec2(notEqual(pixel & half_side, uvec2(0u)));
        index += half_side * half_side * (3u * quarter.x ^ quarter.y);
        pixel = quarter == uvec2(1u, 0u) ? ~pixel : pixel;
        pixel = quarter.y == 0u ? pixel.yx : pixel;
    }
    return index;
}

// Along the curve the numbers step by powers of 1 / 1.2207441, the root of x^4 = x + 1: Roberts 2018, The Unreasonable
// Effectiveness of Quasirandom Sequences. In each frame a pixel is 239 further on, which divides [0, 1) evenly for few
// frames as for many.
vec3 crease_noise(ivec2 pixel) {
    uint place = crease_hilbert_noise_index(uvec2(pixel)) + 239u * crease_frame;
    uvec3 share = place * uvec3(3518319155u, 2882110345u, 2360945575u) + 2147483648u; // fractions of 2^32
    return vec3(share >> 8u) * (1.0 / 16777216.0);
}
#ifdef __cplusplus
")glsl"
#endif
