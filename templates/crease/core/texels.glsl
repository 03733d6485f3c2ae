// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// The depth of background: beyond any radius, and finite, so that its square is finite too.
const float crease_background = 1e15;

// Size in texels of an image at 1 / divisor of the resolution, rounded up.
ivec2 crease_size(int divisor) { return (ivec2(crease_view.resolution) + divisor - 1) / divisor; }

// Size of the depth image in texels, guard band included.
vec2 crease_depth_size() { return crease_view.resolution + 2.0 * crease_view.guard; }

// Whether texel coordinates lie inside the depth image. Compares bits: those of negative numbers and NaN exceed any size's.
bool crease_inside(vec2 texel) {
    return all(lessThan(floatBitsToUint(texel), floatBitsToUint(crease_depth_size())));
}

// Taps outside the image load this texel, as out-of-range loads are undefined; the value is not used.
const vec2 crease_first_texel = vec2(0.0);

// The depth texel of a pixel at 1 / divisor of the resolution.
vec2 crease_texel_of_pixel(ivec2 pixel, int divisor) {
    return vec2(min(pixel * divisor + (divisor - 1) / 2, ivec2(crease_view.resolution) - 1)) + crease_view.guard;
}
#ifdef __cplusplus
")glsl"
#endif
