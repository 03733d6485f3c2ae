// directions:8x4x2/single_layer/hbao_plus/upsample:2/bilateral:4, pass bilateral_x; crease 0.2.0, SPDX-License-Identifier: MIT-0
#version 450
layout(local_size_x = 16, local_size_y = 16, local_size_x_id = 0, local_size_y_id = 1) in;
layout(constant_id = 2) const int crease_bilateral_radius = 4;
const int crease_bilateral_axis = 0;
const int crease_divisor = 1;
const int crease_view_index = 0;
layout(set = 0, binding = 1) uniform usampler2D crease_input;
layout(rg32ui, set = 0, binding = 2) uniform writeonly uimage2D crease_output;

struct crease_view_parameters {
    vec4 from_texel;
    vec2 depth_unpack;
    float far_depth;
    float guard;
    vec2 resolution;
    vec2 texel_size;
};

layout(std140, set = 0, binding = 0) uniform crease_parameters {
    crease_view_parameters views[1];
    float radius;
    uint frame;
    float hbao_plus_bias;
    float strength;
    float exponent;
    float plane_reach;
    float bilateral_sharpness;
} crease_given;

float crease_radius = crease_given.radius;
float crease_bilateral_sharpness = crease_given.bilateral_sharpness;

uvec4 crease_load_input(ivec2 texel) { return texelFetch(crease_input, texel, 0); }

#define crease_write(pixel, result) imageStore(crease_output, pixel, crease_encode_between(result));

// What a pass computes for a pixel.
struct crease_result {
    float visibility; // 1 open, 0 closed
    float depth;      // positive, linear; crease_background where there is none
    vec3 normal;      // view space, unit; filters that weigh by it have it handed on
};

// Shaders index texels of the whole depth image, guard band included, with texel centres at whole numbers.
crease_view_parameters crease_view_of(int index) {
    crease_view_parameters view = crease_given.views[index];
    view.from_texel.zw += (0.5 - view.guard) * view.from_texel.xy;
    return view;
}

// A copy, as some compilers reload uniforms in every iteration.
crease_view_parameters crease_view = crease_view_of(crease_view_index); // of the camera at work

// Size in texels of an image at 1 / divisor of the resolution, rounded up.
ivec2 crease_size(int divisor) { return (ivec2(crease_view.resolution) + divisor - 1) / divisor; }

vec3 crease_unpack_normal(uint word) {
    return vec3(word & 2047u, word >> 11u & 2047u, word >> 22u) * vec3(2.0 / 2047.0, 2.0 / 2047.0, 2.0 / 1023.0) - 1.0;
}

crease_result crease_decode(uvec4 texel) {
    return crease_result(float(texel.x & 255u) * (1.0 / 255.0), uintBitsToFloat(texel.x & ~255u),
                         crease_unpack_normal(texel.y));
}

// One direction of a separable cross-bilateral blur with a depth-slope correction: stochastic-depth-ao 8.1.

// The slope of one side, or where that looks like an edge, that of the other side, extrapolated.
float crease_bilateral_slope(float own, float other, float tightness) {
    return abs(own) * tightness > 1.0 && abs(own) > 2.0 * abs(other) ? -other : own;
}

crease_result crease_sum(crease_result a, crease_result b) {
    return crease_result(a.visibility + b.visibility, a.depth, a.normal);
}

crease_result crease_weighted(crease_result result, float weight) {
    return crease_result(result.visibility * weight, result.depth, result.normal);
}

// The depth of background: beyond any radius, and finite, so that its square is finite too.
const float crease_background = 1e15;

// The mean out of a sum of weighted results and the sum of their weights.
crease_result crease_mean(crease_result sum, float weights, float depth) {
    return crease_result(sum.visibility / weights, depth, sum.normal);
}

crease_result crease_evaluate(ivec2 pixel) {
    ivec2 step = ivec2(crease_bilateral_axis == 0, crease_bilateral_axis == 1);
    vec2 axis = vec2(step);
    ivec2 last = crease_size(crease_divisor) - 1;
    // All are fetched before any is weighed, so that the waits overlap.
    uvec4 texels_before[crease_bilateral_radius];
    uvec4 texels_after[crease_bilateral_radius];
    crease_result own = crease_decode(crease_load_input(pixel));
    for (int i = 0; i < crease_bilateral_radius; ++i) {
        texels_before[i] = crease_load_input(max(pixel - step * (i + 1), ivec2(0)));
        texels_after[i] = crease_load_input(min(pixel + step * (i + 1), last));
    }
    float tightness = crease_bilateral_sharpness / max(crease_radius, 1e-20);
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

// A unit normal in one word, 11, 11 and 10 bits: at most 0.1 degrees away.
uint crease_pack_normal(vec3 normal) {
    uvec3 shares = uvec3(clamp(normal * 0.5 + 0.5, 0.0, 1.0) * vec3(2047.0, 2047.0, 1023.0) + 0.5);
    return shares.x | shares.y << 11u | shares.z << 22u;
}

// Visibility in the low 8 bits, depth in the others, which is exact to 2^-15 of itself; the normal in a word of its own.
uvec4 crease_encode_between(crease_result result) {
    uint word = (floatBitsToUint(result.depth) & ~255u) | uint(result.visibility * 255.0 + 0.5);
    return uvec4(word, crease_pack_normal(result.normal), 0u, 0u);
}

ivec2 crease_pixel() { return ivec2(gl_GlobalInvocationID.xy); }

void main() {
    ivec2 pixel = crease_pixel();
    if (any(greaterThanEqual(pixel, crease_size(crease_divisor))))
        return;
    crease_result result = crease_evaluate(pixel);
    crease_write(pixel, result)
}
