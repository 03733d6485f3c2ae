// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
float crease_range_nearest();
float crease_range_farthest();
float crease_range_mean();
vec3 crease_area_value(vec3 position, float centre);
vec4 crease_area_texel(ivec2 at);
#else
__LINE__, R"glsl("
#endif

// Each texel in the table of its layer, and nothing in the others: statistical-volumetric-obscurance 4.3. Layers are
// equally thick in what the estimator averages.
float crease_summed_area_uniform_value(float depth) {
    return crease_area_value(vec3(0.0, 0.0, -depth), crease_range_mean()).x;
}

void crease_build(ivec2 texel) {
    const int last = crease_summed_area_uniform_layers - 1;
    vec4 sum = crease_area_texel(texel);
    float nearest = crease_summed_area_uniform_value(crease_range_nearest());
    float all = nearest - crease_summed_area_uniform_value(crease_range_farthest());
    float share = (nearest - sum.x / max(sum.y, 1.0)) / max(all, 1e-20);
    int layer = int(clamp(share * float(crease_summed_area_uniform_layers), 0.0, float(last)));
    for (int i = 0; i <= last; ++i)
        imageStore(crease_area_tables, ivec3(texel, i), i == layer ? sum : vec4(0.0));
}
#ifdef __cplusplus
")glsl"
#endif
