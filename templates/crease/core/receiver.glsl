// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
vec3 crease_to_eye(vec3 position);
void crease_axes(vec3 to_eye, out vec3 tangent, out vec3 bitangent);
mat2 crease_disk(vec3 position, vec3 tangent, vec3 bitangent);
#else
__LINE__, R"glsl("
#endif

// The point whose visibility is asked for.
struct crease_receiver {
    ivec2 pixel;             // of the pass's output
    vec2 texel;              // texel space of the depth image
    vec3 position;           // view space
    vec3 normal;             // view space, unit
    vec3 to_eye;             // view space, unit
    vec3 tangent, bitangent; // view space, unit: the axes of the disk that faces the eye
    mat2 disk;               // from offsets on that disk, in AO radii, to texels
};

crease_receiver crease_make_receiver(ivec2 pixel, vec2 texel, vec3 position, vec3 normal) {
    vec3 to_eye = crease_to_eye(position), tangent, bitangent;
    crease_axes(to_eye, tangent, bitangent);
    return crease_receiver(pixel, texel, position, normal, to_eye, tangent, bitangent,
                           crease_disk(position, tangent, bitangent));
}
#ifdef __cplusplus
")glsl"
#endif
