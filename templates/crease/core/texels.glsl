// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// The depth of what is not there: further than any radius, and finite, so that its square is too.
const float crease_background = 1e15;

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
#ifdef __cplusplus
")glsl"
#endif
