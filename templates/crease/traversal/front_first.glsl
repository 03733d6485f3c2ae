// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
crease_layer crease_front_layer(crease_tap tap, crease_fetched fetched);
crease_contribution crease_weigh(crease_march march, crease_receiver receiver, crease_tap tap, crease_layer layer);
bool crease_behind_matters(crease_march march, crease_receiver receiver, crease_tap tap, crease_layer front, float reach, bool by_angle);
crease_layers crease_fetch_layers(vec2 texel);
crease_contribution crease_combine_layers(crease_march march, crease_receiver receiver, crease_tap tap, crease_layers layers, bool wanted);
crease_contribution crease_combine(crease_contribution a, crease_contribution b);
void crease_add(inout crease_march march, crease_contribution contribution);
#else
__LINE__, R"glsl("
#endif

// The front surface of each tap, then at once the layers behind it if they may add occlusion: stochastic-depth-ao 6.3.
void crease_traverse(inout crease_march march, crease_receiver receiver, crease_tap tap, crease_fetched fetched) {
    crease_layer front = crease_front_layer(tap, fetched);
    crease_contribution all = crease_weigh(march, receiver, tap, front);
    if (crease_behind_matters(march, receiver, tap, front, crease_front_first_reach, crease_front_first_angle != 0)) {
        crease_layers layers = crease_fetch_layers(tap.inside ? tap.texel : crease_first_texel);
        all = crease_combine(all, crease_combine_layers(march, receiver, tap, layers, true));
    }
    crease_add(march, all);
}
#ifdef __cplusplus
")glsl"
#endif
