#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
struct crease_view_parameters {
    vec4 from_texel;
    vec2 depth_unpack;
    float far_depth;
    float guard;
    vec2 resolution;
    vec2 texel_size;
};

layout(crease_parameters_place) uniform crease_parameters {
    crease_view_parameters crease_views[2];
    mat4 crease_second_from_first;
    float crease_radius;
    float crease_bias;
    float crease_threshold;
    float crease_strength;
    float crease_exponent;
    float crease_sharpness;
    uint crease_frame;
    float crease_opacity;
    float crease_front_reach;
    float crease_falloff;
};
#ifdef __cplusplus
")glsl"
#endif
