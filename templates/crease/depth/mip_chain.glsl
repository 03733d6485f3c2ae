#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// The sum over a box as texture filters take it: between the texels of two levels of a mip chain, whose two texels are
// as wide as the box: statistical-volumetric-obscurance 3.3.

vec4 crease_areas_at(ivec3 texel);
ivec2 crease_areas_size();
vec4 crease_areas_edges(vec4 area);

int crease_areas_divisor() { return crease_mip_chain_divisor; }

struct crease_areas {
    vec4 sum;
};

// The sum for each texel of level 0 between the texels of a level.
vec4 crease_mip_chain_between(vec2 texel, int level) {
    ivec2 size = (crease_areas_size() + (1 << level) - 1) >> level;
    vec2 corner = texel / float(1 << level) - 0.5;
    ivec2 first = ivec2(floor(corner));
    vec2 share = corner - vec2(first);
    vec4 sum = vec4(0.0);
    crease_unroll for (int j = 0; j < 2; ++j)
        crease_unroll for (int i = 0; i < 2; ++i) {
            ivec2 at = first + ivec2(i, j);
            vec2 weight = mix(1.0 - share, share, vec2(i, j));
            bool inside = at == clamp(at, ivec2(0), size - 1);
            sum += (inside ? weight.x * weight.y : 0.0) * crease_areas_at(ivec3(clamp(at, ivec2(0), size - 1), level));
        }
    return sum / float(1 << (2 * level));
}

crease_areas crease_fetch_areas(vec4 area) {
    vec4 box = crease_areas_edges(area);
    vec2 size = box.zw - box.xy, middle = 0.5 * (box.xy + box.zw);
    float level = clamp(log2(max(max(size.x, size.y), 1.0)) - 1.0, 0.0, float(crease_mip_chain_levels - 1));
    int lower = int(level), upper = min(lower + 1, crease_mip_chain_levels - 1);
    vec4 sum = mix(crease_mip_chain_between(middle, lower), crease_mip_chain_between(middle, upper), fract(level));
    return crease_areas(size.x * size.y * sum);
}

int crease_area_count() { return 1; }

vec4 crease_area_sum(crease_areas areas, int layer) { return areas.sum; }
#ifdef __cplusplus
")glsl"
#endif
