// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// A tap along the ray through the centre of a texel, where that passes through the volume around the receiver.
struct crease_tap {
    vec2 texel;
    bool inside;     // whether the texel is in the depth image; else it has no weight
    float near, far; // depths from the receiver's where the ray enters and leaves; near >= far where it misses
    float under;     // how much of that is under the receiver's tangent plane
    float weight;    // of the tap among those of the receiver, by the area that it stands for
};
#ifdef __cplusplus
")glsl"
#endif
