#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// Sums over areas out of four places of a summed-area table: statistical-volumetric-obscurance 3.4.
//
// The tables of smaller pictures are read between their texels, linearly, as 4.6.1 has it; differences are taken
// before weights, so that the counts of whole texels stay exact.

vec4 crease_areas_at(ivec3 texel);
ivec2 crease_areas_size();
int crease_areas_divisor();

// From edges in the picture to edges in the tables, within them.
vec4 crease_areas_box(vec4 area) {
    vec4 box = area / float(crease_areas_divisor()) + crease_view.guard;
    if (crease_areas_divisor() == 1)
        box = floor(box + 0.5); // the texels whose centres are in the area
    return clamp(box, vec4(0.0), vec4(crease_areas_size().xyxy));
}

// The sum of all texels to the left of and above a corner.
vec4 crease_areas_before(int x, int y, int table) {
    vec4 sum = crease_areas_at(ivec3(max(ivec2(x, y) - 1, ivec2(0)), table));
    return x > 0 && y > 0 ? sum : vec4(0.0);
}

// The sum between two edges of what is above y: `part` lies beyond the whole texels.
vec4 crease_areas_across(ivec2 left, ivec2 right, vec2 part, int y, int table) {
    vec4 to_left = crease_areas_before(left.x, y, table), to_right = crease_areas_before(right.x, y, table);
    return to_right - to_left + (crease_areas_before(right.y, y, table) - to_right) * part.y -
        (crease_areas_before(left.y, y, table) - to_left) * part.x;
}

// The sum over a box of a table.
vec4 crease_areas_over(vec4 box, int table) {
    ivec4 whole = ivec4(box);
    if (crease_areas_divisor() == 1)
        return (crease_areas_before(whole.z, whole.w, table) - crease_areas_before(whole.x, whole.w, table)) -
            (crease_areas_before(whole.z, whole.y, table) - crease_areas_before(whole.x, whole.y, table));
    vec4 part = box - vec4(whole);
    ivec4 next = min(whole + 1, crease_areas_size().xyxy);
    ivec2 left = ivec2(whole.x, next.x), right = ivec2(whole.z, next.z);
    vec4 top = crease_areas_across(left, right, part.xz, whole.y, table);
    vec4 bottom = crease_areas_across(left, right, part.xz, whole.w, table);
    return bottom - top + (crease_areas_across(left, right, part.xz, next.w, table) - bottom) * part.w -
        (crease_areas_across(left, right, part.xz, next.y, table) - top) * part.y;
}
#ifdef __cplusplus
")glsl"
#endif
