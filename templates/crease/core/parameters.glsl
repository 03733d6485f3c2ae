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
} crease_given;

// A camera as shaders use it: in their texel space whole numbers are the centres of the depth image's texels, those of
// the guard band too.
crease_view_parameters crease_view_of(int index) {
    crease_view_parameters view = crease_given.crease_views[index];
    view.from_texel.zw += (0.5 - view.guard) * view.from_texel.xy;
    return view;
}

// Read once, as not every compiler takes the reading out of a loop.
crease_view_parameters crease_view = crease_view_of(crease_view_index); // of the camera at work
float crease_radius = crease_given.crease_radius;
float crease_bias = crease_given.crease_bias;
float crease_threshold = crease_given.crease_threshold;
float crease_strength = crease_given.crease_strength;
float crease_exponent = crease_given.crease_exponent;
float crease_sharpness = crease_given.crease_sharpness;
uint crease_frame = crease_given.crease_frame;
float crease_opacity = crease_given.crease_opacity;
float crease_front_reach = crease_given.crease_front_reach;
float crease_falloff = crease_given.crease_falloff;
#ifdef __cplusplus
")glsl"
#endif
