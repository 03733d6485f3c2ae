// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
uint crease_pack_normal(vec3 normal);
vec3 crease_unpack_normal(uint word);
#else
__LINE__, R"glsl("
#endif

// Visibility in the low 8 bits, depth in the others, which is exact to 2^-15 of itself; the normal in a word of its own.
uvec4 crease_encode_between(crease_result result) {
    uint word = (floatBitsToUint(result.depth) & ~255u) | uint(result.visibility * 255.0 + 0.5);
    return uvec4(word, crease_pack_normal(result.normal), 0u, 0u);
}

crease_result crease_decode(uvec4 texel) {
    return crease_result(float(texel.x & 255u) * (1.0 / 255.0), uintBitsToFloat(texel.x & ~255u),
                         crease_unpack_normal(texel.y));
}
#ifdef __cplusplus
")glsl"
#endif
