#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// Each texel in the table of its layer, and nothing in the others: statistical-volumetric-obscurance 4.3.

float crease_range_nearest();
float crease_range_farthest();
float crease_range_mean();
vec4 crease_area_texel(ivec2 at);

void crease_build(ivec2 texel) {
    vec4 sum = crease_area_texel(texel);
    float depth = crease_range_mean() - sum.z / max(sum.w, 1.0);
    float thickness = max(crease_range_farthest() - crease_range_nearest(), 1e-20) / float(crease_summed_area_uniform_layers);
    int layer = clamp(int((depth - crease_range_nearest()) / thickness), 0, crease_summed_area_uniform_layers - 1);
    for (int i = 0; i < crease_summed_area_uniform_layers; ++i)
        imageStore(crease_area_tables, ivec3(texel, i), i == layer ? sum : vec4(0.0));
}
#ifdef __cplusplus
")glsl"
#endif
