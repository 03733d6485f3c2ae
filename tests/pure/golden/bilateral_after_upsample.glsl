#version 450
#extension GL_EXT_control_flow_attributes : enable
#define crease_unroll [[unroll]]
layout(local_size_x = 16, local_size_y = 16, local_size_x_id = 0, local_size_y_id = 1) in;
layout(constant_id = 2) const int crease_bilateral_radius = 4;
const int crease_bilateral_axis = 0;
const int crease_divisor = 1;
const int crease_workgroup_columns = 0;
const int crease_input_divisor = 1;
const int crease_view_index = 0;
#define crease_decode crease_decode_visibility_depth
#define crease_write(pixel, result) imageStore(crease_output, pixel, crease_encode_visibility_depth(result));
layout(r32ui, set = 0, binding = 1) uniform readonly uimage2D crease_input;
layout(r32ui, set = 0, binding = 2) uniform writeonly uimage2D crease_output;
#define crease_parameters_place std140, set = 0, binding = 0
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
// SPDX-License-Identifier: MIT
// The depth of what is not there: further than any radius, and finite, so that its square is too.
const float crease_background = 1e15;

// What crease_view.far_depth is of the distance of the far plane: see set_projection.
const float crease_far_share = 0.999;

// Size in texels of an image whose sides are the picture's divided by `divisor`, rounded up.
ivec2 crease_size(int divisor) { return (ivec2(crease_view.resolution) + divisor - 1) / divisor; }

// Of the depth image in texels, guard band included.
vec2 crease_depth_size() { return crease_view.resolution + 2.0 * crease_view.guard; }

// Whether texel coordinates lie in the depth image. As whole numbers the bits of what is negative or NaN are greater
// than those of any size.
bool crease_inside(vec2 texel) {
    return all(lessThan(floatBitsToUint(texel), floatBitsToUint(crease_depth_size())));
}

// What is loaded in place of a texel beside the depth image, where reading would find anything at all.
const vec2 crease_first_texel = vec2(0.0);

// The texel that stands for a pixel of a picture that is smaller by `divisor`.
vec2 crease_texel_of_pixel(ivec2 pixel, int divisor) {
    return vec2(min(pixel * divisor + (divisor - 1) / 2, ivec2(crease_view.resolution) - 1)) + crease_view.guard;
}
// SPDX-License-Identifier: MIT
// What a pass computes for a pixel.
struct crease_result {
    float visibility; // 1 open, 0 closed
    float depth;      // positive, linear; crease_background where there is none
};

crease_result crease_open() { return crease_result(1.0, crease_background); }

crease_result crease_weighted(crease_result result, float weight) {
    return crease_result(result.visibility * weight, result.depth);
}

crease_result crease_sum(crease_result a, crease_result b) {
    return crease_result(a.visibility + b.visibility, a.depth);
}

// The mean out of a sum of weighted results and the sum of their weights.
crease_result crease_mean(crease_result sum, float weights, float depth) {
    return crease_result(sum.visibility / weights, depth);
}
// SPDX-License-Identifier: MIT
// Visibility in the low 8 bits, depth in the others: a depth is exact to 2^-15 of itself.

uvec4 crease_encode_visibility_depth(crease_result result) {
    return uvec4((floatBitsToUint(result.depth) & ~255u) | uint(result.visibility * 255.0 + 0.5));
}

crease_result crease_decode_visibility_depth(uvec4 texel) {
    return crease_result(float(texel.x & 255u) * (1.0 / 255.0), uintBitsToFloat(texel.x & ~255u));
}
// SPDX-License-Identifier: MIT
// One direction of a separable cross-bilateral blur with a depth-slope correction: stochastic-depth-ao 8.1.

crease_result crease_decode(uvec4 texel);
crease_result crease_weighted(crease_result result, float weight);
crease_result crease_sum(crease_result a, crease_result b);
crease_result crease_mean(crease_result sum, float weights, float depth);

// The slope of one side, or where that looks like an edge, the other side's carried on.
float crease_bilateral_slope(float own, float other, float tightness) {
    return abs(own) * tightness > 1.0 && abs(own) > 2.0 * abs(other) ? -other : own;
}

crease_result crease_evaluate(ivec2 pixel) {
    ivec2 step = ivec2(crease_bilateral_axis == 0, crease_bilateral_axis == 1);
    vec2 axis = vec2(step);
    ivec2 last = crease_size(crease_divisor) - 1;
    // All are fetched before any is weighed, so that the waits overlap.
    uvec4 texels_before[crease_bilateral_radius], texels_after[crease_bilateral_radius];
    crease_result own = crease_decode(imageLoad(crease_input, pixel));
    for (int i = 0; i < crease_bilateral_radius; ++i) {
        texels_before[i] = imageLoad(crease_input, max(pixel - step * (i + 1), ivec2(0)));
        texels_after[i] = imageLoad(crease_input, min(pixel + step * (i + 1), last));
    }
    float tightness = crease_sharpness / max(crease_radius, 1e-20);
    float rise_before = crease_decode(texels_before[0]).depth - own.depth;
    float rise_after = crease_decode(texels_after[0]).depth - own.depth;
    float slope_before = crease_bilateral_slope(rise_before, rise_after, tightness);
    float slope_after = crease_bilateral_slope(rise_after, rise_before, tightness);
    float room_before = dot(vec2(pixel), axis);
    float room_after = dot(vec2(crease_size(crease_divisor) - 1), axis) - room_before;
    const float spread = 2.0 / float(crease_bilateral_radius * crease_bilateral_radius);
    crease_result sum = own;
    float weights = 1.0;
    for (int i = 0; i < crease_bilateral_radius; ++i) {
        float away = float(i + 1);
        crease_result before = crease_decode(texels_before[i]), after = crease_decode(texels_after[i]);
        float apart_before = (before.depth - own.depth - slope_before * away) * tightness;
        float apart_after = (after.depth - own.depth - slope_after * away) * tightness;
        float weight_before = exp2(-spread * away * away - apart_before * apart_before);
        float weight_after = exp2(-spread * away * away - apart_after * apart_after);
        weight_before = room_before < away ? 0.0 : weight_before;
        weight_after = room_after < away ? 0.0 : weight_after;
        sum = crease_sum(sum, crease_sum(crease_weighted(before, weight_before), crease_weighted(after, weight_after)));
        weights += weight_before + weight_after;
    }
    if (!(own.depth < 0.99 * crease_background)) // the encoding rounds it
        return own;
    return crease_mean(sum, weights, own.depth);
}
// SPDX-License-Identifier: MIT
crease_result crease_evaluate(ivec2 pixel);

// The workgroup's place: in rows, or in columns that are so many wide, as a texel has left the cache when a row of a large
// picture comes to it again. Quotients are of floats, as many devices have none of whole numbers.
uvec2 crease_workgroup() {
    uvec2 place = gl_WorkGroupID.xy;
    if (crease_workgroup_columns > 0) {
        const float width = float(crease_workgroup_columns);
        vec2 groups = vec2(uvec2(crease_size(crease_divisor) - 1) / gl_WorkGroupSize.xy + 1u);
        float index = float(place.y) * groups.x + float(place.x);
        float column = floor((index + 0.5) / (width * groups.y)), within = index - column * width * groups.y;
        float here = min(width, groups.x - column * width), row = floor((within + 0.5) / here);
        place = uvec2(column * width + within - row * here, row);
    }
    return place;
}

void main() {
    ivec2 pixel = ivec2(crease_workgroup() * gl_WorkGroupSize.xy + gl_LocalInvocationID.xy);
    if (all(lessThan(pixel, crease_size(crease_divisor)))) {
        crease_result result = crease_evaluate(pixel);
        crease_write(pixel, result)
    }
}
