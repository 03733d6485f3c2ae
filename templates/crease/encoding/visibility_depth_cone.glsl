// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
vec2 crease_octahedron(vec3 direction);
uint crease_pack_normal(vec3 normal);
vec3 crease_unpack_normal(uint word);
#else
__LINE__, R"glsl("
#endif

// Visibility and depth in one word, as without a cone; in the other the bent normal in octahedral encoding, 12 bits
// each way, and the cone's half angle in 8; in a third the normal.
uvec4 crease_encode_between(crease_result result) {
    uvec2 point = uvec2(crease_octahedron(result.bent) * 2047.0 + 2048.0);
    uint word = (floatBitsToUint(result.depth) & ~255u) | uint(result.visibility * 255.0 + 0.5);
    uint cone = uint(clamp(result.cone * (255.0 / 1.57079633), 0.0, 255.0) + 0.5);
    return uvec4(word, point.x | point.y << 12u | cone << 24u, crease_pack_normal(result.normal), 0u);
}

crease_result crease_decode(uvec4 texel) {
    vec2 point = (vec2(texel.y & 4095u, texel.y >> 12u & 4095u) - 2047.5) / 2047.0;
    vec3 bent = vec3(point, 1.0 - abs(point.x) - abs(point.y));
    float outside = max(-bent.z, 0.0);
    bent.xy -= outside * vec2(bent.x < 0.0 ? -1.0 : 1.0, bent.y < 0.0 ? -1.0 : 1.0);
    return crease_result(float(texel.x & 255u) * (1.0 / 255.0), uintBitsToFloat(texel.x & ~255u),
                         crease_unpack_normal(texel.z), normalize(bent), float(texel.y >> 24u) * (1.57079633 / 255.0));
}
#ifdef __cplusplus
")glsl"
#endif
