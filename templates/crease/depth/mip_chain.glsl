// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
vec4 crease_areas_at(ivec3 texel);
ivec2 crease_areas_size();
vec4 crease_areas_edges(vec4 area);
vec3 crease_area_mean(vec4 sum);
#else
__LINE__, R"glsl("
#endif

// The sum over a box as a trilinear filter takes it: the four texels around its middle in each of the two levels of a
// mip chain whose texels are about half as wide as the box: statistical-volumetric-obscurance 3.3. Each is a layer of
// its own, as the mean of all would take a far surface in one texel for a near one.
int crease_areas_divisor() { return crease_mip_chain_divisor; }

const int crease_most_layers = 8;

struct crease_layers {
    vec4 sums[8];
};

// The four texels of a level, weighed as a filter does; together they stand for `texels` texels of level 0.
void crease_mip_chain_between(inout crease_layers layers, vec2 texel, int level, int to, float texels) {
    ivec2 size = (crease_areas_size() + (1 << level) - 1) >> level;
    vec2 corner = texel / float(1 << level) - 0.5;
    ivec2 first = ivec2(floor(corner));
    vec2 share = corner - vec2(first);
    crease_unroll for (int j = 0; j < 2; ++j)
        crease_unroll for (int i = 0; i < 2; ++i) {
            ivec2 at = first + ivec2(i, j);
            vec2 weight = mix(1.0 - share, share, vec2(i, j));
            bool inside = at == clamp(at, ivec2(0), size - 1);
            float texels_of_each = inside ? texels * weight.x * weight.y : 0.0;
            layers.sums[to + 2 * j + i] = crease_areas_at(ivec3(clamp(at, ivec2(0), size - 1), level)) *
                (texels_of_each / float(1 << (2 * level)));
        }
}

crease_layers crease_fetch_area(vec4 area) {
    vec4 box = crease_areas_edges(area);
    vec2 size = box.zw - box.xy, middle = 0.5 * (box.xy + box.zw);
    float level = clamp(log2(max(max(size.x, size.y), 1.0)) - 1.0, 0.0, float(crease_mip_chain_levels - 1));
    int lower = int(level), upper = min(lower + 1, crease_mip_chain_levels - 1);
    float texels = size.x * size.y;
    crease_layers layers;
    crease_mip_chain_between(layers, middle, lower, 0, texels * (1.0 - fract(level)));
    crease_mip_chain_between(layers, middle, upper, 4, texels * fract(level));
    return layers;
}

crease_layer crease_layer_at(crease_layers layers, int i) {
    return crease_layer(crease_area_mean(layers.sums[i]), layers.sums[i].y);
}
#ifdef __cplusplus
")glsl"
#endif
