#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// Layers of equal depth between the nearest and the farthest of the picture: statistical-volumetric-obscurance 4.3.

ivec4 crease_areas_box(vec4 area);
vec4 crease_areas_over(ivec4 box, int table);

int crease_areas_divisor() { return crease_summed_area_uniform_divisor; }

struct crease_areas {
    ivec4 box;
};

crease_areas crease_fetch_areas(vec4 area) { return crease_areas(crease_areas_box(area)); }

int crease_area_count() { return crease_summed_area_uniform_layers; }

vec4 crease_area_sum(crease_areas areas, int layer) { return crease_areas_over(areas.box, layer); }
#ifdef __cplusplus
")glsl"
#endif
