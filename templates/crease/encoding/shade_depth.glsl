// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
crease_result crease_shade_result(float shade, float depth, vec3 normal);
uint crease_pack_normal(vec3 normal);
vec3 crease_unpack_normal(uint word);
#else
__LINE__, R"glsl("
#endif

// Shade, depth and the normal; visibility is computed from the shade again.
uvec4 crease_encode_between(crease_result result) {
    return uvec4(floatBitsToUint(result.shade), floatBitsToUint(result.depth), crease_pack_normal(result.normal), 0u);
}

crease_result crease_decode(uvec4 texel) {
    return crease_shade_result(uintBitsToFloat(texel.x), uintBitsToFloat(texel.y), crease_unpack_normal(texel.z));
}
#ifdef __cplusplus
")glsl"
#endif
