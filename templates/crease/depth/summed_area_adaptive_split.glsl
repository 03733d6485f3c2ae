#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// Splits each layer of one level by its mean over the sample area around each texel, and stores the nearer part:
// statistical-volumetric-obscurance 4.4, Algorithm 2, lines 4, 8 and 9. The tables of the level begin with
// `crease_summed_area_adaptive_split`. From the first split to the last, which fills it, the last table holds the texels
// themselves, the number of each one's layer beside its count.

vec3 crease_to_eye(vec3 position);
void crease_axes(vec3 to_eye, out vec3 across, out vec3 up);
mat2 crease_disk(vec3 position, vec3 across, vec3 up);
vec3 crease_area_mean(vec4 sum);
vec4 crease_sample_area(vec2 texel, mat2 disk);
ivec4 crease_areas_box(vec4 area);
vec4 crease_areas_over(ivec4 box, int table);
vec4 crease_area_texel(ivec2 at);

const int crease_summed_area_adaptive_step = 32; // of a layer's number, beyond any count

// The sum over a box of a layer of this level: bit k of its number says whether it is the farther part of split k.
vec4 crease_summed_area_adaptive_sum(ivec4 box, int layer) {
    vec4 sum = crease_areas_over(box, 0);
    crease_unroll for (int level = 0; level < 2; ++level) {
        int first = 1 << level;
        if (first < crease_summed_area_adaptive_split) {
            vec4 nearer = crease_areas_over(box, first + (layer & (first - 1)));
            sum = (layer & first) == 0 ? nearer : sum - nearer;
        }
    }
    return sum;
}

void crease_build(ivec2 texel) {
    const int first = crease_summed_area_adaptive_split, step = crease_summed_area_adaptive_step;
    const ivec3 kept = ivec3(texel, crease_summed_area_adaptive_layers - 1);
    vec4 own = first == 1 ? crease_area_texel(texel) : imageLoad(crease_area_tables, kept);
    int layer = int(own.y) / step;
    own.y -= float(step * layer);
    bool nearer = false;
    if (own.y > 0.0) {
        vec3 position = crease_area_mean(own);
        vec3 across, up;
        crease_axes(crease_to_eye(position), across, up);
        vec2 middle = (vec2(texel) + 0.5 - crease_view.guard) * float(crease_divisor);
        ivec4 box = crease_areas_box(crease_sample_area(middle, crease_disk(position, across, up)));
        vec4 sum = crease_summed_area_adaptive_sum(box, layer);
        // By a margin, so that rounding does not scatter a surface that faces the eye over both; z points to the eye.
        nearer = position.z - crease_area_mean(sum).z > 0.01 * crease_radius;
    }
    crease_unroll for (int i = first; i < min(2 * first, crease_summed_area_adaptive_layers); ++i)
        imageStore(crease_area_tables, ivec3(texel, i), nearer && i == first + layer ? own : vec4(0.0));
    if (2 * first < crease_summed_area_adaptive_layers)
        imageStore(crease_area_tables, kept, own + vec4(0.0, step * (nearer ? layer : layer + first), 0.0, 0.0));
}
#ifdef __cplusplus
")glsl"
#endif
