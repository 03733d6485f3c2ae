// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// Numbers that repeat from tile to tile of pixels: statistical-volumetric-obscurance 2.2. Those of a tile, and of the
// next frame's after it, step by the golden ratio and by the root of 2, and so divide [0, 1) evenly however many.
vec2 crease_noise(ivec2 pixel) {
    const uint side = uint(crease_tiled_noise_side);
    uvec2 within = uvec2(pixel) % side;
    uint place = (crease_frame * side + within.y) * side + within.x;
    uvec2 share = place * uvec2(2654435769u, 1779033703u) + 2147483648u; // of 2^32; of the first the half
    return vec2(share >> 8u) * (1.0 / 16777216.0);
}
#ifdef __cplusplus
")glsl"
#endif
