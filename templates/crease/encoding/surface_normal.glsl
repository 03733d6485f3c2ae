// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
vec2 crease_octahedron(vec3 direction);
#else
__LINE__, R"glsl("
#endif

// A unit normal in 24 bits: octahedral encoding, 12 bits each way.
uint crease_pack_surface_normal(vec3 normal) {
    uvec2 point = uvec2(crease_octahedron(normal) * 2047.0 + 2048.5);
    return point.x | point.y << 12u;
}

vec3 crease_unpack_surface_normal(uint word) {
    vec2 point = (vec2(word & 4095u, word >> 12u & 4095u) - 2048.0) / 2047.0;
    vec3 normal = vec3(point, 1.0 - abs(point.x) - abs(point.y));
    float outside = max(-normal.z, 0.0);
    normal.xy -= outside * vec2(normal.x < 0.0 ? -1.0 : 1.0, normal.y < 0.0 ? -1.0 : 1.0);
    return normalize(normal);
}
#ifdef __cplusplus
")glsl"
#endif
