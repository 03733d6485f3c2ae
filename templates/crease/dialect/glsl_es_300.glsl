// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// Bits that are set, by sums of pairs, fours and eights: GLSL ES counts them from 3.10 on.
int crease_bit_count(uint bits) {
    bits -= bits >> 1u & 0x55555555u;
    bits = (bits & 0x33333333u) + (bits >> 2u & 0x33333333u);
    return int((bits + (bits >> 4u) & 0x0f0f0f0fu) * 0x01010101u >> 24u);
}
#ifdef __cplusplus
")glsl"
#endif
