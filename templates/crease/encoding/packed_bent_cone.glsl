// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
vec2 crease_octahedron(vec3 direction);
#else
__LINE__, R"glsl("
#endif

// The bent normal in octahedral encoding, the cone's half angle as a share of a right angle, and visibility.
vec4 crease_encode_packed_bent_cone(crease_result result) {
    return vec4(crease_octahedron(result.bent) * 0.5 + 0.5, result.cone * (1.0 / 1.57079633), result.visibility);
}
#ifdef __cplusplus
")glsl"
#endif
