#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// Shade and depth; visibility follows from the shade.

crease_result crease_shade_result(float shade, float depth);

uvec4 crease_encode_shade_depth(crease_result result) {
    return uvec4(floatBitsToUint(result.shade), floatBitsToUint(result.depth), 0u, 0u);
}

crease_result crease_decode_shade_depth(uvec4 texel) {
    return crease_shade_result(uintBitsToFloat(texel.x), uintBitsToFloat(texel.y));
}
#ifdef __cplusplus
")glsl"
#endif
