// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
float crease_depth_at(vec2 texel);
vec3 crease_view_position(vec2 texel, float depth);
crease_contribution crease_weigh(crease_march march, crease_receiver receiver, crease_tap tap, crease_layer layer);
#else
__LINE__, R"glsl("
#endif

// One layer, the depth image's.
struct crease_layers {
    vec2 texel;
    float depth;
};

const int crease_most_layers = 1;

crease_layers crease_fetch_layers(vec2 texel) { return crease_layers(texel, crease_depth_at(texel)); }

int crease_layer_count(crease_layers layers) { return 1; }

crease_layer crease_layer_at(crease_layers layers, int i) {
    return crease_layer(crease_view_position(layers.texel, layers.depth), 1.0);
}

crease_contribution crease_combine_first_layers(crease_march march, crease_receiver receiver, crease_tap tap,
                                                crease_layers layers) {
    return crease_weigh(march, receiver, tap, crease_layer_at(layers, 0));
}
#ifdef __cplusplus
")glsl"
#endif
