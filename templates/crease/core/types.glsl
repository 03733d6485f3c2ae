#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// The point whose visibility is asked for.
struct crease_receiver {
    ivec2 pixel;   // of the pass's output
    vec2 texel;    // texel space of the depth image
    vec3 position; // view space
    vec3 normal;   // view space, unit
    vec3 to_eye;   // view space, unit
    vec3 across, up; // view space, unit: the axes of the disk that faces the eye
    mat2 disk;       // offsets on that disk, in units of the AO radius, to texels
};

// What a pass computes for a pixel.
struct crease_result {
    float visibility; // 1 open, 0 closed
    float depth;      // positive, linear; crease_background where there is none
};

// The depth of what is not there: further than any radius, and finite, so that its square is too.
const float crease_background = 1e15;

// Size in texels of an image whose sides are the picture's divided by `divisor`, rounded up.
ivec2 crease_size(int divisor) { return (ivec2(crease_resolution) + divisor - 1) / divisor; }

// Whether texel coordinates lie in the picture; false where they are NaN.
bool crease_inside(vec2 texel) {
    vec2 middle = 0.5 * crease_resolution;
    return all(lessThan(abs(texel - middle), middle));
}

// The texel of the picture that stands for a pixel of a picture that is smaller by `divisor`.
vec2 crease_texel_of_pixel(ivec2 pixel, int divisor) {
    return vec2(min(pixel * divisor + (divisor - 1) / 2, ivec2(crease_resolution) - 1)) + 0.5;
}
#ifdef __cplusplus
")glsl"
#endif
