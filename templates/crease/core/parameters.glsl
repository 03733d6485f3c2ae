#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
uniform crease_parameters {
    vec4 crease_view_from_texel;
    vec2 crease_depth_unpack;
    float crease_far_depth;
    float crease_radius;
    vec2 crease_resolution;
    vec2 crease_texel_size;
    float crease_bias;
    float crease_threshold;
    float crease_strength;
    float crease_exponent;
    float crease_sharpness;
    uint crease_frame;
};
#ifdef __cplusplus
")glsl"
#endif
