// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// Visibility by strength and exponent: stochastic-depth-ao 8.1.
float crease_visibility_of(float occlusion) {
    return pow(clamp(1.0 - occlusion * crease_strength, 0.0, 1.0), crease_exponent);
}
#ifdef __cplusplus
")glsl"
#endif
