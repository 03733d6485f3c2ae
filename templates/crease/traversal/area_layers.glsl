// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
crease_layers crease_fetch_area(vec4 area);
crease_layer crease_layer_at(crease_layers layers, int i);
crease_contribution crease_weigh(crease_march march, crease_receiver receiver, crease_tap tap, crease_layer layer);
void crease_add(inout crease_march march, crease_contribution contribution);
#else
__LINE__, R"glsl("
#endif

// Each layer of an area counts by its number of texels: statistical-volumetric-obscurance 4.3, equation 4.4. Nothing is
// fetched ahead, as the layers of an area are too many to keep for a batch of taps.
struct crease_fetched {
    bool nothing;
};

crease_fetched crease_fetch(vec2 texel) { return crease_fetched(false); }

void crease_traverse_area(inout crease_march march, crease_receiver receiver, crease_tap tap, crease_layers layers,
                          int i) {
    crease_layer layer = crease_layer_at(layers, i);
    crease_contribution own = crease_weigh(march, receiver, tap, layer);
    if (layer.texels >= 0.01) // less is rounding
        crease_add(march, own);
}

const int crease_most_areas_unrolled = 8;

void crease_traverse(inout crease_march march, crease_receiver receiver, crease_tap tap, crease_fetched fetched) {
    crease_layers layers = crease_fetch_area(tap.area);
    if (crease_most_layers <= crease_most_areas_unrolled) {
        crease_unroll for (int i = 0; i < crease_most_layers; ++i)
            crease_traverse_area(march, receiver, tap, layers, i);
    } else {
        for (int i = 0; i < crease_most_layers; ++i)
            crease_traverse_area(march, receiver, tap, layers, i);
    }
}
#ifdef __cplusplus
")glsl"
#endif
