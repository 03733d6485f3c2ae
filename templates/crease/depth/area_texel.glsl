#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// What a texel of a table stands for: the sum of what the estimator takes means of, over the picture's texels in it that
// count, and their number: statistical-volumetric-obscurance 4.5 and 4.6.1.

float crease_depth_at(vec2 texel);
vec3 crease_view_position(vec2 texel, float depth);
float crease_range_mean();
float crease_area_depth(float depth);
vec3 crease_area_value(vec3 position, float centre);

vec4 crease_area_texel(ivec2 at) {
    vec2 first = (vec2(at) - crease_view.guard) * float(crease_divisor) + 0.5;
    vec4 sum = vec4(0.0);
    crease_unroll for (int j = 0; j < crease_divisor; ++j)
        crease_unroll for (int i = 0; i < crease_divisor; ++i) {
            vec2 texel = first + vec2(i, j);
            float depth = crease_area_depth(crease_depth_at(texel));
            vec3 value = crease_area_value(crease_view_position(texel, depth), crease_range_mean());
            if (crease_inside(texel) && depth > 0.0)
                sum += vec4(value.x, 1.0, value.yz);
        }
    return sum;
}
#ifdef __cplusplus
")glsl"
#endif
