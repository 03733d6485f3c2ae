// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
ivec4 crease_areas_box(vec4 area);
vec4 crease_areas_over(ivec4 box, int table);
vec3 crease_area_mean(vec4 sum);
#else
__LINE__, R"glsl("
#endif

// Layers that adapt to what is near a texel: statistical-volumetric-obscurance 4.4 and 4.6.2, Algorithm 2.
//
// Table 0 holds all texels. Table t splits layer t - 2^k, of the greatest 2^k up to t: it holds the nearer part, which
// keeps the layer's number, and the difference is the farther part, layer t.
int crease_areas_divisor() { return crease_summed_area_adaptive_divisor; }

const int crease_most_layers = crease_summed_area_adaptive_layers;

struct crease_layers {
    vec4 sums[8]; // of the layers
};

crease_layers crease_fetch_area(vec4 area) {
    ivec4 box = crease_areas_box(area);
    crease_layers layers;
    layers.sums[0] = crease_areas_over(box, 0);
    crease_unroll for (int table = 1; table < crease_summed_area_adaptive_layers; ++table) {
        int layer = table - (table < 2 ? 1 : table < 4 ? 2 : 4);
        vec4 nearer = crease_areas_over(box, table);
        layers.sums[table] = layers.sums[layer] - nearer;
        layers.sums[layer] = nearer;
    }
    return layers;
}

crease_layer crease_layer_at(crease_layers layers, int i) {
    return crease_layer(crease_area_mean(layers.sums[i]), layers.sums[i].y);
}
#ifdef __cplusplus
")glsl"
#endif
