#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
crease_result crease_evaluate(ivec2 pixel);

void main() { crease_output = crease_encode(crease_evaluate(ivec2(gl_FragCoord.xy))); }
#ifdef __cplusplus
")glsl"
#endif
