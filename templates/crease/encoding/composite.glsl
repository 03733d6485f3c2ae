// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
uint crease_pack_normal(vec3 normal);
vec3 crease_unpack_normal(uint word);
#else
__LINE__, R"glsl("
#endif

// Visibility in the low 8 bits, depth in the others; the normal; color and opacity as halves.
uvec4 crease_encode_between(crease_result result) {
    uint word = (floatBitsToUint(result.depth) & ~255u) | uint(result.visibility * 255.0 + 0.5);
    return uvec4(word, crease_pack_normal(result.normal), packHalf2x16(result.color.rg),
                 packHalf2x16(result.color.ba));
}

crease_result crease_decode(uvec4 texel) {
    return crease_result(float(texel.x & 255u) * (1.0 / 255.0), uintBitsToFloat(texel.x & ~255u),
                         crease_unpack_normal(texel.y),
                         vec4(unpackHalf2x16(texel.z), unpackHalf2x16(texel.w)));
}
#ifdef __cplusplus
")glsl"
#endif
