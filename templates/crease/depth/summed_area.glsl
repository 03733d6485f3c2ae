#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// One layer: all that the picture shows.

ivec4 crease_areas_box(vec4 area);
vec4 crease_areas_over(ivec4 box, int table);

int crease_areas_divisor() { return crease_summed_area_divisor; }

struct crease_areas {
    vec4 sum;
};

crease_areas crease_fetch_areas(vec4 area) { return crease_areas(crease_areas_over(crease_areas_box(area), 0)); }

int crease_area_count() { return 1; }

vec4 crease_area_sum(crease_areas areas, int layer) { return areas.sum; }
#ifdef __cplusplus
")glsl"
#endif
