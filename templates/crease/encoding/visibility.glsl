#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// Visibility alone.
vec4 crease_encode_visibility(crease_result result) { return vec4(result.visibility); }
#ifdef __cplusplus
")glsl"
#endif
