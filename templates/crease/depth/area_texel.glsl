// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
float crease_depth_at(vec2 texel);
vec3 crease_view_position(vec2 texel, float depth);
float crease_range_mean();
float crease_area_depth(float depth);
vec3 crease_area_value(vec3 position, float centre);
#else
__LINE__, R"glsl("
#endif

// A texel of a table: the sum of what the estimator averages, over those of the picture's texels in it that count, and
// their number: statistical-volumetric-obscurance 4.5 and 4.6.1.

// The first texel of the depth image that a texel of a table stands for.
vec2 crease_area_corner(ivec2 at) {
    return (vec2(at) - crease_view.guard) * float(crease_divisor) + crease_view.guard;
}

// The share of one texel of the picture, which is (i, j) of those that the table's texel stands for.
vec4 crease_area_part(ivec2 at, int i, int j) {
    vec2 texel = crease_area_corner(at) + vec2(i, j);
    float depth = crease_area_depth(crease_depth_at(texel));
    vec3 value = crease_area_value(crease_view_position(texel, depth), crease_range_mean());
    return crease_inside(texel) && depth > 0.0 ? vec4(value.x, 1.0, value.yz) : vec4(0.0);
}

vec4 crease_area_texel(ivec2 at) {
    vec4 sum = vec4(0.0);
    crease_unroll for (int j = 0; j < crease_divisor; ++j)
        crease_unroll for (int i = 0; i < crease_divisor; ++i)
            sum += crease_area_part(at, i, j);
    return sum;
}
#ifdef __cplusplus
")glsl"
#endif
