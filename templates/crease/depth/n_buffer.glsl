#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// The sum over a box out of four squares of an N-buffer, one in each corner: statistical-volumetric-obscurance 3.3. What
// two of them share counts twice, so a box is exact where its sides are powers of two.

ivec4 crease_areas_box(vec4 area);
vec4 crease_areas_at(ivec3 texel);

int crease_areas_divisor() { return crease_n_buffer_divisor; }

struct crease_areas {
    vec4 sum;
};

crease_areas crease_fetch_areas(vec4 area) {
    ivec4 box = crease_areas_box(area);
    ivec2 size = box.zw - box.xy;
    int level = clamp(findMSB(min(size.x, size.y)), 0, crease_n_buffer_levels - 1), side = 1 << level;
    ivec2 last = max(box.zw - side, 0), first = min(box.xy, last);
    vec4 sum = crease_areas_at(ivec3(first, level)) + crease_areas_at(ivec3(last.x, first.y, level)) +
        crease_areas_at(ivec3(first.x, last.y, level)) + crease_areas_at(ivec3(last, level));
    float texels = float(size.x * size.y);
    return crease_areas(sum * (texels / float(4 * side * side))); // as many as the box has
}

int crease_area_count() { return 1; }

vec4 crease_area_sum(crease_areas areas, int layer) { return areas.sum; }
#ifdef __cplusplus
")glsl"
#endif
