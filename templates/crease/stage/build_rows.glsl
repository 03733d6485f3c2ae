#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
void crease_build_line(int line);

void main() { crease_build_line(int(gl_GlobalInvocationID.y)); }
#ifdef __cplusplus
")glsl"
#endif
