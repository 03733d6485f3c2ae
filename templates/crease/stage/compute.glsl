#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
crease_result crease_evaluate(ivec2 pixel);

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (all(lessThan(pixel, crease_size(crease_divisor)))) {
        crease_result result = crease_evaluate(pixel);
        crease_write(pixel, result)
    }
}
#ifdef __cplusplus
")glsl"
#endif
