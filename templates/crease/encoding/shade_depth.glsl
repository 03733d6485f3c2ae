// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
crease_result crease_shade_result(float shade, float depth);
#else
__LINE__, R"glsl("
#endif

// Shade and depth; visibility is computed from the shade again.
uvec4 crease_encode_between(crease_result result) {
    return uvec4(floatBitsToUint(result.shade), floatBitsToUint(result.depth), 0u, 0u);
}

crease_result crease_decode(uvec4 texel) {
    return crease_shade_result(uintBitsToFloat(texel.x), uintBitsToFloat(texel.y));
}
#ifdef __cplusplus
")glsl"
#endif
