// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

ivec2 crease_pixel() { return ivec2(gl_GlobalInvocationID.xy); }
#ifdef __cplusplus
")glsl"
#endif
