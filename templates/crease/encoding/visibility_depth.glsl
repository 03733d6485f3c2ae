// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// Visibility in the low 8 bits, depth in the others, which is exact to 2^-15 of itself.
uvec4 crease_encode_between(crease_result result) {
    return uvec4((floatBitsToUint(result.depth) & ~255u) | uint(result.visibility * 255.0 + 0.5));
}

crease_result crease_decode(uvec4 texel) {
    return crease_result(float(texel.x & 255u) * (1.0 / 255.0), uintBitsToFloat(texel.x & ~255u));
}
#ifdef __cplusplus
")glsl"
#endif
