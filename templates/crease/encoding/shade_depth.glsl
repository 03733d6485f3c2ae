#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// Shade and depth; visibility follows from the shade.

crease_result crease_shade_result(float shade, float depth);

vec4 crease_encode_shade_depth(crease_result result) { return vec4(result.shade, result.depth, 0.0, 0.0); }

crease_result crease_decode_shade_depth(vec4 texel) { return crease_shade_result(texel.x, texel.y); }
#ifdef __cplusplus
")glsl"
#endif
