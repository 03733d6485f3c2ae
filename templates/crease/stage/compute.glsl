// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
ivec2 crease_pixel();
crease_result crease_evaluate(ivec2 pixel);
#else
__LINE__, R"glsl("
#endif

void main() {
    ivec2 pixel = crease_pixel();
    if (any(greaterThanEqual(pixel, crease_size(crease_divisor))))
        return;
    crease_result result = crease_evaluate(pixel);
    crease_write(pixel, result)
}
#ifdef __cplusplus
")glsl"
#endif
