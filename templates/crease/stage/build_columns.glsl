// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
void crease_build_line(int line);
#else
__LINE__, R"glsl("
#endif

void main() {
    crease_build_line(int(gl_GlobalInvocationID.x));
}
#ifdef __cplusplus
")glsl"
#endif
