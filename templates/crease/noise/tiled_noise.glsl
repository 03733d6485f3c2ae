// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// Numbers that repeat from tile to tile of pixels: statistical-volumetric-obscurance 2.2. Within a tile, and on into
// the next frame, they step by the golden ratio and by the square roots of 2 and of 3, so that any number of them divides
// [0, 1) evenly.
vec3 crease_noise(ivec2 pixel) {
    const uint side = uint(crease_tiled_noise_side);
    uvec2 within = uvec2(pixel) % uvec2(side);
    uint place = (crease_frame * side + within.y) * side + within.x;
    uvec3 share = place * uvec3(2654435769u, 1779033703u, 3144134277u) + 2147483648u; // fractions of 2^32
    return vec3(share >> 8u) * (1.0 / 16777216.0);
}
#ifdef __cplusplus
")glsl"
#endif
