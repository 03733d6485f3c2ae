#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// The point whose visibility is asked for.
struct crease_receiver {
    ivec2 pixel;   // of the pass's output
    vec2 texel;    // texel space of the depth image
    vec3 position; // view space
    vec3 normal;   // view space, unit
    vec3 to_eye;   // view space, unit
    vec3 across, up; // view space, unit: the axes of the disk that faces the eye
    mat2 disk;       // offsets on that disk, in units of the AO radius, to texels
};
#ifdef __cplusplus
")glsl"
#endif
