#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// Splits each layer of one level by its mean over the sample area around each texel, and stores the nearer part:
// statistical-volumetric-obscurance 4.4, Algorithm 2, lines 4, 8 and 9. The tables of the level begin with
// `crease_summed_area_adaptive_split`.

vec3 crease_to_eye(vec3 position);
void crease_axes(vec3 to_eye, out vec3 across, out vec3 up);
mat2 crease_disk(vec3 position, vec3 across, vec3 up);
vec3 crease_area_mean(vec4 sum);
vec4 crease_sample_area(vec2 texel, mat2 disk);
vec4 crease_areas_box(vec4 area);
vec4 crease_areas_over(vec4 box, int table);
vec4 crease_area_texel(ivec2 at);

// The layer that a texel is in before this level, and that layer's sum over the sample area.
int crease_summed_area_adaptive_layer_of(ivec2 texel, vec4 box, out vec4 sum) {
    int layer = 0;
    sum = crease_areas_over(box, 0);
    for (int first = 1; first < crease_summed_area_adaptive_split; first *= 2) {
        vec4 nearer = crease_areas_over(box, layer + first);
        bool is_nearer = crease_areas_over(vec4(texel, texel + 1), layer + first).w > 0.0;
        sum = is_nearer ? nearer : sum - nearer;
        layer += is_nearer ? 0 : first;
    }
    return layer;
}

void crease_build(ivec2 texel) {
    const int first = crease_summed_area_adaptive_split;
    vec4 own = crease_area_texel(texel);
    int table = -1; // that of the texel; none where it is farther, or background
    if (own.w > 0.0) {
        vec3 position = crease_area_mean(own);
        vec3 across, up;
        crease_axes(crease_to_eye(position), across, up);
        vec2 middle = (vec2(texel) + 0.5 - crease_view.guard) * float(crease_divisor);
        vec4 box = crease_areas_box(crease_sample_area(middle, crease_disk(position, across, up)));
        vec4 sum;
        int layer = crease_summed_area_adaptive_layer_of(texel, box, sum);
        // By a margin, so that rounding does not scatter a surface that faces the eye over both; z points to the eye.
        if (position.z - crease_area_mean(sum).z > 0.01 * crease_radius)
            table = first + layer;
    }
    for (int i = first; i < min(2 * first, crease_summed_area_adaptive_layers); ++i)
        imageStore(crease_area_tables, ivec3(texel, i), i == table ? own : vec4(0.0));
}
#ifdef __cplusplus
")glsl"
#endif
