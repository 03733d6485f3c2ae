#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
crease_result crease_evaluate(ivec2 pixel);

void main() {
    crease_result result = crease_evaluate(ivec2(gl_FragCoord.xy));
    crease_write(pixel, result)
}
#ifdef __cplusplus
")glsl"
#endif
