#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// The layers of an area count by how many texels they hold in it: statistical-volumetric-obscurance 4.3, equation 4.4.

crease_areas crease_fetch_areas(vec4 area);
int crease_area_count();
vec4 crease_area_sum(crease_areas areas, int layer);
vec3 crease_area_mean(vec4 sum);
crease_contribution crease_weigh(crease_estimate estimate, crease_receiver receiver, crease_tap tap, vec3 position);

const int crease_fold_written_out = 8; // layers up to which no loop is left, as a loop costs some drivers dearly

void crease_fold_layer(inout crease_contribution all, crease_estimate estimate, crease_receiver receiver,
                       crease_tap tap, vec4 sum) {
    crease_contribution own = crease_weigh(estimate, receiver, tap, crease_area_mean(sum));
    bool empty = sum.y < 0.01; // what differences of tables leave
    all.occlusion += empty ? 0.0 : sum.y * own.occlusion;
    all.texels += empty ? 0.0 : sum.y * own.texels;
}

crease_contribution crease_fold(crease_estimate estimate, crease_receiver receiver, crease_tap tap,
                                crease_layers layers) {
    crease_contribution all = crease_contribution(0.0, 0.0);
    crease_areas areas = crease_fetch_areas(tap.area);
    if (crease_area_count() <= crease_fold_written_out) {
        crease_unroll for (int layer = 0; layer < crease_area_count(); ++layer)
            crease_fold_layer(all, estimate, receiver, tap, crease_area_sum(areas, layer));
    } else {
        for (int layer = 0; layer < crease_area_count(); ++layer)
            crease_fold_layer(all, estimate, receiver, tap, crease_area_sum(areas, layer));
    }
    return all;
}
#ifdef __cplusplus
")glsl"
#endif
