// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
ivec4 crease_areas_box(vec4 area);
vec4 crease_areas_over(ivec4 box, int table);
vec3 crease_area_mean(vec4 sum);
#else
__LINE__, R"glsl("
#endif

// One layer: the mean of all that an area of the picture holds.
int crease_areas_divisor() { return crease_summed_area_divisor; }

const int crease_most_layers = 1;

struct crease_layers {
    vec4 sum;
};

crease_layers crease_fetch_area(vec4 area) { return crease_layers(crease_areas_over(crease_areas_box(area), 0)); }

crease_layer crease_layer_at(crease_layers layers, int i) {
    return crease_layer(crease_area_mean(layers.sum), layers.sum.y);
}
#ifdef __cplusplus
")glsl"
#endif
