// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
crease_layers crease_fetch_layers(vec2 texel);
int crease_layer_count(crease_layers layers);
crease_layer crease_layer_at(crease_layers layers, int i);
crease_contribution crease_weigh(crease_march march, crease_receiver receiver, crease_tap tap, crease_layer layer);
crease_contribution crease_combine(crease_contribution a, crease_contribution b);
#else
__LINE__, R"glsl("
#endif

// What a depth source finds by default.

// The layers that are fetched before it is known which of them are there.
crease_layers crease_fetch_first_layers(vec2 texel) { return crease_fetch_layers(texel); }

// The layers that were fetched, of which there is at least one; `wanted`: whether they matter.
crease_contribution crease_combine_layers(crease_march march, crease_receiver receiver, crease_tap tap,
                                          crease_layers layers, bool wanted) {
    crease_contribution all = crease_weigh(march, receiver, tap, crease_layer_at(layers, 0));
    for (int i = 1; wanted && i < crease_layer_count(layers); ++i)
        all = crease_combine(all, crease_weigh(march, receiver, tap, crease_layer_at(layers, i)));
    return all;
}

// All layers of a tap, of which the first are fetched.
crease_contribution crease_combine_first_layers(crease_march march, crease_receiver receiver, crease_tap tap,
                                                crease_layers layers) {
    return crease_combine_layers(march, receiver, tap, layers, true);
}
#ifdef __cplusplus
")glsl"
#endif
