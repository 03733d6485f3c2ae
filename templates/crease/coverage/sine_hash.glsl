// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// Hashes of real numbers to [0, 1), nested as stochastic-depth-ao 8.2 nests them; the innermost is that of Wyman and
// McGuire, Hashed Alpha Testing, 2017.
float crease_hash_2d(vec2 v) {
    return fract(1.0e4 * sin(17.0 * v.x + 0.1 * v.y) * (0.1 + abs(sin(13.0 * v.y + v.x))));
}

float crease_hash_3d(vec3 v) { return crease_hash_2d(vec2(crease_hash_2d(v.xy), v.z)); }

float crease_hash_4d(vec4 v) { return crease_hash_2d(vec2(crease_hash_3d(v.xyz), v.w)); }
#ifdef __cplusplus
")glsl"
#endif
