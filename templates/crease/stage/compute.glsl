#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
crease_result crease_evaluate(ivec2 pixel);

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (all(lessThan(pixel, crease_size(crease_divisor))))
        imageStore(crease_output, pixel, crease_encode(crease_evaluate(pixel)));
}
#ifdef __cplusplus
")glsl"
#endif
