// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// A layer of a texel of a smaller picture: its view-space position, as bits, and its normal below its opacity.
uvec4 crease_no_coarse_layer() { return uvec4(floatBitsToUint(vec3(0.0, 0.0, -crease_background)), 0u); }

bool crease_is_coarse_layer(uvec4 layer) { return uintBitsToFloat(layer.z) > -0.5 * crease_background; }
#ifdef __cplusplus
")glsl"
#endif
