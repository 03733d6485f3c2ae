// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// Octahedral encoding of a direction of any length, in [-1, 1] each way; a zero vector becomes the direction to the
// eye.
vec2 crease_octahedron(vec3 direction) {
    vec3 way = abs(direction);
    vec2 point = direction.xy / (way.x + way.y + way.z + 1e-20);
    if (direction.z < 0.0)
        point = (1.0 - abs(point.yx)) * vec2(point.x < 0.0 ? -1.0 : 1.0, point.y < 0.0 ? -1.0 : 1.0);
    return point;
}
#ifdef __cplusplus
")glsl"
#endif
