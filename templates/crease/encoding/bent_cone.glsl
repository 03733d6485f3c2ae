// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// The bent normal, unit, and the cone's angle.
vec4 crease_encode_bent_cone(crease_result result) {
    return vec4(result.bent * inversesqrt(max(dot(result.bent, result.bent), 1e-30)), result.cone);
}
#ifdef __cplusplus
")glsl"
#endif
