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
} crease_given;

// Read once, as not every compiler takes the reading out of a loop.
vec4 crease_view_from_texel = crease_given.crease_view_from_texel;
vec2 crease_depth_unpack = crease_given.crease_depth_unpack;
float crease_far_depth = crease_given.crease_far_depth;
float crease_radius = crease_given.crease_radius;
vec2 crease_resolution = crease_given.crease_resolution;
vec2 crease_texel_size = crease_given.crease_texel_size;
float crease_bias = crease_given.crease_bias;
float crease_threshold = crease_given.crease_threshold;
float crease_strength = crease_given.crease_strength;
float crease_exponent = crease_given.crease_exponent;
float crease_sharpness = crease_given.crease_sharpness;
uint crease_frame = crease_given.crease_frame;
#ifdef __cplusplus
")glsl"
#endif
