// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
vec3 crease_view_position(vec2 texel, float depth);
crease_layer crease_layer_of(vec3 position);
#else
__LINE__, R"glsl("
#endif

// Samples of a texel, each of which keeps a layer.
int crease_sample_count() { return crease_stochastic_layers_count; }

const int crease_most_layers = crease_stochastic_layers_count;

// What lies behind a layer does not matter, as its samples were kept at random.
crease_layer crease_packed_layer(vec2 texel, float depth, float behind) {
    return crease_layer_of(crease_view_position(texel, depth));
}
#ifdef __cplusplus
")glsl"
#endif
