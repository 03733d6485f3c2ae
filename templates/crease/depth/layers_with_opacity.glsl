// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
vec3 crease_view_position(vec2 texel, float depth);
#else
__LINE__, R"glsl("
#endif

// Layers that tell front from back faces, and their opacity.
struct crease_layer {
    vec3 position;   // view space
    float texels;    // it stands for: 1
    float thickness; // crease_layer_thickness
    float opacity;   // 0 to 1
};

crease_layer crease_layer_of(vec3 position) { return crease_layer(position, 1.0, -1.0, 1.0); }

// What an opaque front face begins is solid. A transparent surface is one alone, as rays meet it.
crease_layer crease_packed_layer(vec2 texel, float depth, float behind, float opacity) {
    bool alone = depth < 0.0 || opacity < 1.0, ends = behind < crease_background;
    float thickness = alone ? 0.0 : ends ? max(-behind - depth, 0.0) : -1.0;
    return crease_layer(crease_view_position(texel, abs(depth)), 1.0, thickness, opacity);
}
#ifdef __cplusplus
")glsl"
#endif
