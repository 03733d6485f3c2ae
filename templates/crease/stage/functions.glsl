// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
crease_result crease_evaluate(ivec2 pixel);
uvec4 crease_encode_between(crease_result result);
#else
__LINE__, R"glsl("
#endif

// Visibility of a pixel of the pass's output: 1 open, 0 closed.
float crease_visibility(ivec2 pixel) {
    return crease_evaluate(pixel).visibility;
}

// What the next pass reads of a pixel.
uvec4 crease_handed_on(ivec2 pixel) {
    return crease_encode_between(crease_evaluate(pixel));
}
#ifdef __cplusplus
")glsl"
#endif
