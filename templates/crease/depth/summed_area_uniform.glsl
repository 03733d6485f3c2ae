// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
ivec4 crease_areas_box(vec4 area);
vec4 crease_areas_over(ivec4 box, int table);
vec3 crease_area_mean(vec4 sum);
#else
__LINE__, R"glsl("
#endif

// Layers of equal depth between the nearest and the farthest of the picture: statistical-volumetric-obscurance 4.3.
int crease_areas_divisor() { return crease_summed_area_uniform_divisor; }

const int crease_most_layers = crease_summed_area_uniform_layers;

struct crease_layers {
    ivec4 box;
};

crease_layers crease_fetch_area(vec4 area) { return crease_layers(crease_areas_box(area)); }

crease_layer crease_layer_at(crease_layers layers, int i) {
    vec4 sum = crease_areas_over(layers.box, i);
    return crease_layer(crease_area_mean(sum), sum.y);
}
#ifdef __cplusplus
")glsl"
#endif
