// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// A tap on the screen, at the centre of a texel, on the way along a half slice.
struct crease_tap {
    vec2 texel;
    bool inside;    // whether the texel is in the depth image, and not the receiver's; else it has no weight
    float weight;   // of the tap among those of the receiver, in a mean over the distances or the area around it
    float distance; // from the receiver, radii, more than 0
    float gap;      // between the taps around it, as a share of its distance
};
#ifdef __cplusplus
")glsl"
#endif
