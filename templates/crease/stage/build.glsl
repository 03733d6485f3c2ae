// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
void crease_build(ivec2 texel);
#else
__LINE__, R"glsl("
#endif

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    if (all(lessThan(texel, crease_build_size)))
        crease_build(texel);
}
#ifdef __cplusplus
")glsl"
#endif
