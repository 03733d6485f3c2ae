// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// Shade alone.
vec4 crease_encode_shade(crease_result result) { return vec4(result.shade); }
#ifdef __cplusplus
")glsl"
#endif
