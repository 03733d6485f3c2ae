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

// Fetches the layers that are worth fetching before any is weighed: by default all.
crease_layers crease_fetch_first_layers(vec2 texel) { return crease_fetch_layers(texel); }

// Combines fetched layers, at least one; if not `wanted`, the result is not used.
crease_contribution crease_combine_layers(crease_march march, crease_receiver receiver, crease_tap tap,
                                          crease_layers layers, bool wanted) {
    crease_contribution all = crease_weigh(march, receiver, tap, crease_layer_at(layers, 0));
    for (int i = 1; wanted && i < crease_layer_count(layers); ++i)
        all = crease_combine(all, crease_weigh(march, receiver, tap, crease_layer_at(layers, i)));
    return all;
}

// Combines all layers of a tap, the first of which are fetched already.
crease_contribution crease_combine_first_layers(crease_march march, crease_receiver receiver, crease_tap tap,
                                                crease_layers layers) {
    return crease_combine_layers(march, receiver, tap, layers, true);
}
#ifdef __cplusplus
")glsl"
#endif
