#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// The layers of an area count by how many texels they hold in it: statistical-volumetric-obscurance 4.3, equation 4.4.

crease_areas crease_fetch_areas(vec4 area);
int crease_area_count(crease_areas areas);
vec4 crease_area_sum(crease_areas areas, int layer);
vec3 crease_area_mean(vec4 sum);
crease_contribution crease_weigh(crease_estimate estimate, crease_receiver receiver, crease_tap tap, vec3 position);

crease_contribution crease_fold(crease_estimate estimate, crease_receiver receiver, crease_tap tap,
                                crease_layers layers) {
    crease_contribution all = crease_contribution(0.0, 0.0);
    crease_areas areas = crease_fetch_areas(tap.area);
    for (int layer = 0; layer < crease_area_count(areas); ++layer) {
        vec4 sum = crease_area_sum(areas, layer);
        if (sum.w < 0.01) // what differences of tables leave of an empty layer
            continue;
        crease_contribution own = crease_weigh(estimate, receiver, tap, crease_area_mean(sum));
        all.occlusion += sum.w * own.occlusion;
        all.texels += sum.w * own.texels;
    }
    return all;
}
#ifdef __cplusplus
")glsl"
#endif
