// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
crease_result crease_evaluate(ivec2 pixel);
#else
__LINE__, R"glsl("
#endif

void main() {
    crease_result result = crease_evaluate(ivec2(gl_FragCoord.xy));
    crease_write(pixel, result)
}
#ifdef __cplusplus
")glsl"
#endif
