// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
ivec4 crease_areas_box(vec4 area);
vec4 crease_areas_at(ivec3 texel);
vec3 crease_area_mean(vec4 sum);
#else
__LINE__, R"glsl("
#endif

// The sums over a box by four squares of an N-buffer, one in each corner: statistical-volumetric-obscurance 3.3. What
// two of them share counts twice, so a box is exact where its sides are powers of two. Each is a layer of its own, as
// the mean of all would take a far surface in one corner for a near one.
int crease_areas_divisor() { return crease_n_buffer_divisor; }

const int crease_most_layers = 4;

struct crease_layers {
    vec4 sums[4];
};

crease_layers crease_fetch_area(vec4 area) {
    ivec4 box = crease_areas_box(area);
    ivec2 size = box.zw - box.xy;
    int level = clamp(findMSB(min(size.x, size.y)), 0, crease_n_buffer_levels - 1), side = 1 << level;
    ivec2 last = max(box.zw - side, 0), first = min(box.xy, last);
    float share = float(size.x * size.y) / float(4 * side * side); // of the box's texels, a quarter
    return crease_layers(vec4[](share * crease_areas_at(ivec3(first, level)),
                               share * crease_areas_at(ivec3(last.x, first.y, level)),
                               share * crease_areas_at(ivec3(first.x, last.y, level)),
                               share * crease_areas_at(ivec3(last, level))));
}

crease_layer crease_layer_at(crease_layers layers, int i) {
    return crease_layer(crease_area_mean(layers.sums[i]), layers.sums[i].y);
}
#ifdef __cplusplus
")glsl"
#endif
