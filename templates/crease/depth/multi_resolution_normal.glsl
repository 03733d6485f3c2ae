// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
vec2 crease_octahedron(vec3 direction);
#else
__LINE__, R"glsl("
#endif

// The normals of smaller pictures: on an octahedron, in 16 bits each way.
uint crease_multi_resolution_pack(vec3 normal) { return packSnorm2x16(crease_octahedron(normal)); }

vec3 crease_multi_resolution_normal(uint word) {
    vec2 point = unpackSnorm2x16(word);
    vec3 normal = vec3(point, 1.0 - abs(point.x) - abs(point.y));
    float below = max(-normal.z, 0.0);
    normal.x -= point.x < 0.0 ? -below : below;
    normal.y -= point.y < 0.0 ? -below : below;
    return normalize(normal);
}
#ifdef __cplusplus
")glsl"
#endif
