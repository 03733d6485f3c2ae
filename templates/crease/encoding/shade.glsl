#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// Shade alone.
vec4 crease_encode_shade(crease_result result) { return vec4(result.shade); }
#ifdef __cplusplus
")glsl"
#endif
