// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
uvec3 crease_hashed_noise_mix(uvec3 v);
#else
__LINE__, R"glsl("
#endif

// Random bits of a fragment: those of one texel differ by their depth, those of one frame by its index.
uvec3 crease_fragment_noise(uint salt) {
    uvec2 pixel = uvec2(gl_FragCoord.xy) + crease_frame * uvec2(0x9e3779b9u, 0x7f4a7c15u);
    return crease_hashed_noise_mix(uvec3(pixel, floatBitsToUint(gl_FragCoord.z) + salt * 0x85ebca6bu));
}

float crease_unit_float(uint bits) { return float(bits >> 8u) * (1.0 / 16777216.0); }
#ifdef __cplusplus
")glsl"
#endif
