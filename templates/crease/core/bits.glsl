// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// Bits that are set.
int crease_bit_count(uint bits) { return bitCount(int(bits)); }
#ifdef __cplusplus
")glsl"
#endif
