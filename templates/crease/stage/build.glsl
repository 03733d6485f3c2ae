#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
void crease_build(ivec2 texel);

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    if (all(lessThan(texel, crease_build_size)))
        crease_build(texel);
}
#ifdef __cplusplus
")glsl"
#endif
