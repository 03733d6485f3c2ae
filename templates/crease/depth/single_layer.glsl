#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// One layer of depth, that of the receivers.

float crease_depth_at(vec2 texel);

struct crease_layers {
    float depth;
};

crease_layers crease_fetch_layers(vec2 texel) { return crease_layers(crease_depth_at(texel)); }

int crease_layer_count() { return 1; }

float crease_layer_depth(crease_layers layers, int layer) { return layers.depth; }
#ifdef __cplusplus
")glsl"
#endif
