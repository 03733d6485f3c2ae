#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// A tap has no layers before its fold: what an area holds is too much to keep for a batch of taps.
int crease_area_count();

struct crease_layers {
    bool unused;
};

crease_layers crease_fetch_layers(vec2 texel) { return crease_layers(false); }

int crease_layer_count() { return crease_area_count(); }
#ifdef __cplusplus
")glsl"
#endif
