// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// A unit normal in one word, 11, 11 and 10 bits: at most 0.1 degrees away.
uint crease_pack_normal(vec3 normal) {
    uvec3 shares = uvec3(clamp(normal * 0.5 + 0.5, 0.0, 1.0) * vec3(2047.0, 2047.0, 1023.0) + 0.5);
    return shares.x | shares.y << 11u | shares.z << 22u;
}

vec3 crease_unpack_normal(uint word) {
    return vec3(word & 2047u, word >> 11u & 2047u, word >> 22u) * vec3(2.0 / 2047.0, 2.0 / 2047.0, 2.0 / 1023.0) - 1.0;
}
#ifdef __cplusplus
")glsl"
#endif
