#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// The bent normal and the cone's angle.
vec4 crease_encode_bent_cone(crease_result result) { return vec4(result.bent, result.cone); }
#ifdef __cplusplus
")glsl"
#endif
