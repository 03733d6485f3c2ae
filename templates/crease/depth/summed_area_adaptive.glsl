#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// Layers that adapt to what is near a texel: statistical-volumetric-obscurance 4.4 and 4.6.2, Algorithm 2.
//
// Table 0 holds all texels. Table t splits layer t - 2^k, of the greatest 2^k up to t: it holds the nearer part, which
// keeps the layer's number, and the difference is the farther part, layer t.

ivec4 crease_areas_box(vec4 area);
vec4 crease_areas_over(ivec4 box, int table);

int crease_areas_divisor() { return crease_summed_area_adaptive_divisor; }

struct crease_areas {
    vec4 sums[8]; // of the layers
};

crease_areas crease_fetch_areas(vec4 area) {
    ivec4 box = crease_areas_box(area);
    crease_areas areas;
    areas.sums[0] = crease_areas_over(box, 0);
    crease_unroll for (int table = 1; table < crease_summed_area_adaptive_layers; ++table) {
        int layer = table - (table < 2 ? 1 : table < 4 ? 2 : 4);
        vec4 nearer = crease_areas_over(box, table);
        areas.sums[table] = areas.sums[layer] - nearer;
        areas.sums[layer] = nearer;
    }
    return areas;
}

int crease_area_count() { return crease_summed_area_adaptive_layers; }

vec4 crease_area_sum(crease_areas areas, int layer) { return areas.sums[layer]; }
#ifdef __cplusplus
")glsl"
#endif
