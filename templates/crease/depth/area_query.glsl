// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
vec4 crease_areas_at(ivec3 texel);
#else
__LINE__, R"glsl("
#endif

// Sums over areas out of four places of a summed-area table: statistical-volumetric-obscurance 3.4.

// The sum of all texels to the left of and above a corner.
vec4 crease_areas_before(int x, int y, int table) {
    vec4 sum = crease_areas_at(ivec3(max(ivec2(x, y) - 1, ivec2(0)), table));
    return x > 0 && y > 0 ? sum : vec4(0.0);
}

// The sum over a box of a table.
vec4 crease_areas_over(ivec4 box, int table) {
    return (crease_areas_before(box.z, box.w, table) - crease_areas_before(box.x, box.w, table)) -
        (crease_areas_before(box.z, box.y, table) - crease_areas_before(box.x, box.y, table));
}
#ifdef __cplusplus
")glsl"
#endif
