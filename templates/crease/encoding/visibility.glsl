// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// Visibility alone.
vec4 crease_encode_visibility(crease_result result) { return vec4(result.visibility); }
#ifdef __cplusplus
")glsl"
#endif
