// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// Layers with an opacity: the slab that waits for the next tap hides some of its sectors.
struct crease_march {
    vec3 height, along;
    float bias;
    float reach;
    vec2 constant, linear, square, cubic;
    float weight;
    vec2 towards;
    uint hidden;
    float occlusion;
    int taps;
    crease_cosine_bitmask_slab last;
    float before_last;
    uint of_last; // sectors that the last slab may hide
};
#ifdef __cplusplus
")glsl"
#endif
