#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// The layers of an area count by how many texels they hold in it: statistical-volumetric-obscurance 4.3, equation 4.4.
// An area of less than 2 x 2 texels tells less, and one that holds the receiver alone nothing.

crease_areas crease_fetch_areas(vec4 area);
int crease_area_count(crease_areas areas);
vec4 crease_area_sum(crease_areas areas, int layer);
vec3 crease_area_mean(vec4 sum);
crease_contribution crease_weigh(crease_estimate estimate, crease_receiver receiver, crease_tap tap, vec3 position);

crease_contribution crease_fold(crease_estimate estimate, crease_receiver receiver, crease_tap tap,
                                crease_layers layers) {
    crease_areas areas = crease_fetch_areas(tap.area);
    crease_contribution mean = crease_contribution(0.0);
    float texels = 0.0;
    for (int layer = 0; layer < crease_area_count(areas); ++layer) {
        vec4 sum = crease_area_sum(areas, layer);
        if (sum.w < 0.01) // what differences of tables leave of an empty layer
            continue;
        mean.occlusion += sum.w * crease_weigh(estimate, receiver, tap, crease_area_mean(sum)).occlusion;
        texels += sum.w;
    }
    mean.occlusion *= clamp((texels - 1.0) / 3.0, 0.0, 1.0) / max(texels, 1.0);
    return mean;
}
#ifdef __cplusplus
")glsl"
#endif
