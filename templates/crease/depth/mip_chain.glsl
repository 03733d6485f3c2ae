#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// The sums over a box by the texels that texture filters take: four around its middle in each of two levels of a mip
// chain, of which two texels are as wide as the box: statistical-volumetric-obscurance 3.3. Each is a layer of its own,
// as the mean of all would take a far surface in one texel for a near one.

vec4 crease_areas_at(ivec3 texel);
ivec2 crease_areas_size();
vec4 crease_areas_edges(vec4 area);

int crease_areas_divisor() { return crease_mip_chain_divisor; }

struct crease_areas {
    vec4 sums[8];
};

// Those of a level, as a filter weighs them, out of as many texels of level 0 as `texels` says.
void crease_mip_chain_between(inout crease_areas areas, vec2 texel, int level, int to, float texels) {
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
            areas.sums[to + 2 * j + i] = crease_areas_at(ivec3(clamp(at, ivec2(0), size - 1), level)) *
                (texels_of_each / float(1 << (2 * level)));
        }
}

crease_areas crease_fetch_areas(vec4 area) {
    vec4 box = crease_areas_edges(area);
    vec2 size = box.zw - box.xy, middle = 0.5 * (box.xy + box.zw);
    float level = clamp(log2(max(max(size.x, size.y), 1.0)) - 1.0, 0.0, float(crease_mip_chain_levels - 1));
    int lower = int(level), upper = min(lower + 1, crease_mip_chain_levels - 1);
    float texels = size.x * size.y;
    crease_areas areas;
    crease_mip_chain_between(areas, middle, lower, 0, texels * (1.0 - fract(level)));
    crease_mip_chain_between(areas, middle, upper, 4, texels * fract(level));
    return areas;
}

int crease_area_count() { return 8; }

vec4 crease_area_sum(crease_areas areas, int layer) { return areas.sums[layer]; }
#ifdef __cplusplus
")glsl"
#endif
