// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
vec3 crease_to_eye(vec3 position);
void crease_axes(vec3 to_eye, out vec3 tangent, out vec3 bitangent);
mat2 crease_disk(vec3 position, vec3 tangent, vec3 bitangent);
vec3 crease_area_mean(vec4 sum);
vec4 crease_sample_area(vec2 texel, mat2 disk);
ivec4 crease_areas_box(vec4 area);
vec4 crease_areas_over(ivec4 box, int table);
vec2 crease_area_corner(ivec2 at);
vec4 crease_area_part(ivec2 at, int i, int j);
vec4 crease_area_texel(ivec2 at);
#else
__LINE__, R"glsl("
#endif

// Splits each layer of one level by its mean over the sample area around each texel, and stores the nearer part:
// statistical-volumetric-obscurance 4.4, Algorithm 2, lines 4, 8 and 9. The tables of the level begin with
// `crease_summed_area_adaptive_split`. The splits of the levels before are made once more, as they read the same
// places. Each texel of the picture chooses its layer on its own, also where a texel of a smaller table stands for
// several.
int crease_areas_divisor() { return crease_divisor; }

const int crease_summed_area_adaptive_most = 4; // layers that one level splits

struct crease_summed_area_adaptive_means {
    float z[2 * crease_summed_area_adaptive_most]; // at k + i of layer i of k
};

// The means of the layers of this level and of those before it, over a box.
crease_summed_area_adaptive_means crease_summed_area_adaptive_around(ivec4 box) {
    vec4 sums[crease_summed_area_adaptive_most];
    crease_summed_area_adaptive_means means;
    sums[0] = crease_areas_over(box, 0);
    means.z[1] = crease_area_mean(sums[0]).z;
    crease_unroll for (int table = 1; table < crease_summed_area_adaptive_split; ++table) {
        int level = table < 2 ? 1 : 2, layer = table - level;
        vec4 nearer = crease_areas_over(box, table);
        sums[table] = sums[layer] - nearer;
        sums[layer] = nearer;
        means.z[2 * level + layer] = crease_area_mean(sums[layer]).z;
        means.z[2 * level + table] = crease_area_mean(sums[table]).z;
    }
    return means;
}

void crease_build(ivec2 texel) {
    const int first = crease_summed_area_adaptive_split;
    vec4 own = crease_area_texel(texel);
    vec4 nearer[crease_summed_area_adaptive_most];
    crease_unroll for (int i = 0; i < first; ++i)
        nearer[i] = vec4(0.0);
    if (own.y > 0.0) {
        vec3 position = crease_area_mean(own);
        vec3 tangent, bitangent;
        crease_axes(crease_to_eye(position), tangent, bitangent);
        vec2 middle = crease_area_corner(texel) + 0.5 * float(crease_divisor - 1);
        ivec4 box = crease_areas_box(crease_sample_area(middle, crease_disk(position, tangent, bitangent)));
        crease_summed_area_adaptive_means means = crease_summed_area_adaptive_around(box);
        // By a margin, so that rounding does not scatter a surface that faces the eye over both; z points to the eye.
        float margin = 0.01 * crease_radius;
        crease_unroll for (int part = 0; part < crease_divisor * crease_divisor; ++part) {
            vec4 sum = crease_area_part(texel, part % crease_divisor, part / crease_divisor);
            float z = crease_area_mean(sum).z;
            int layer = 1; // as in the means
            crease_unroll for (int i = 1; i < 2 * first; ++i) {
                int level = i < 2 ? 1 : i < 4 ? 2 : 4;
                bool is_nearer = z - means.z[i] > margin;
                layer = layer == i ? i + (is_nearer ? level : 2 * level) : layer;
            }
            crease_unroll for (int i = 0; i < first; ++i)
                nearer[i] += layer == 2 * first + i ? sum : vec4(0.0);
        }
    }
    crease_unroll for (int i = 0; i < first; ++i)
        if (first + i < crease_summed_area_adaptive_layers)
            imageStore(crease_area_splits, ivec3(texel, i), nearer[i]);
}
#ifdef __cplusplus
")glsl"
#endif
