// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
crease_layers crease_fetch_first_layers(vec2 texel);
crease_contribution crease_combine_first_layers(crease_march march, crease_receiver receiver, crease_tap tap, crease_layers layers);
void crease_add(inout crease_march march, crease_contribution contribution);
#else
__LINE__, R"glsl("
#endif

struct crease_fetched {
    crease_layers layers;
};

crease_fetched crease_fetch(vec2 texel) { return crease_fetched(crease_fetch_first_layers(texel)); }

void crease_traverse(inout crease_march march, crease_receiver receiver, crease_tap tap, crease_fetched fetched) {
    crease_add(march, crease_combine_first_layers(march, receiver, tap, fetched.layers));
}

// Captured layers are kept if they do not lie before the depth image's: those were drawn to samples off the texel's centre.
bool crease_keeps_layer(float depth, float front) { return depth >= front - 1e-4 * front; }
#ifdef __cplusplus
")glsl"
#endif
