#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// Sums over areas out of four places of a summed-area table: statistical-volumetric-obscurance 3.4. The texels of a
// table whose centres are in the area count, those of smaller pictures too: a read between texels takes four times as
// many places.

vec4 crease_areas_at(ivec3 texel);
ivec2 crease_areas_size();
int crease_areas_divisor();

// From edges in the picture to those in the tables, whole and within them.
ivec4 crease_areas_box(vec4 area) {
    vec4 box = floor(area / float(crease_areas_divisor()) + crease_view.guard + 0.5);
    return ivec4(clamp(box, vec4(0.0), vec4(crease_areas_size().xyxy)));
}

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
