// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// A surface at a texel.
struct crease_layer {
    vec3 position; // view space
    float texels;  // it stands for: 1, or the number of texels of an area
};

// A layer of a texel of which no more is known.
crease_layer crease_layer_of(vec3 position) { return crease_layer(position, 1.0); }

// The depth from a layer to where what it is the front of ends: 0 where it ends at once; negative: not known.
float crease_layer_thickness(crease_layer layer) { return -1.0; }
#ifdef __cplusplus
")glsl"
#endif
