#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// What a texel of a table stands for: the sum of the view-space positions of the picture's texels in it that are no
// background, and their count: statistical-volumetric-obscurance 4.5 and 4.6.1. Positions count from the mean depth,
// so that sums stay small.

float crease_depth_at(vec2 texel);
vec3 crease_view_position(vec2 texel, float depth);
float crease_range_mean();

vec4 crease_area_texel(ivec2 at) {
    vec3 centre = vec3(0.0, 0.0, -crease_range_mean());
    vec2 first = (vec2(at) - crease_view.guard) * float(crease_divisor) + 0.5;
    vec4 sum = vec4(0.0);
    for (int j = 0; j < crease_divisor; ++j)
        for (int i = 0; i < crease_divisor; ++i) {
            vec2 texel = first + vec2(i, j);
            float depth = crease_depth_at(texel);
            if (crease_inside(texel) && depth > 0.0 && depth < crease_background)
                sum += vec4(crease_view_position(texel, depth) - centre, 1.0);
        }
    return sum;
}
#ifdef __cplusplus
")glsl"
#endif
