// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// The area of the picture that the sample box around a receiver covers, its edges left, top, right and bottom in
// texels: statistical-volumetric-obscurance 4.2. `disk` is crease_disk_of the receiver. Its sides are half the AO radius,
// where it comes nearest to the ray-traced truth of that radius.
vec4 crease_sample_area(vec2 texel, mat2 disk) {
    vec2 reach = 0.25 * vec2(length(vec2(disk[0].x, disk[1].x)), length(vec2(disk[0].y, disk[1].y)));
    return vec4(texel + 0.5 - reach, texel + 0.5 + reach);
}
#ifdef __cplusplus
")glsl"
#endif
