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
    vec2 disk_x, disk_y;     // texels that an AO radius along these axes takes
};

// Receivers of a texel.
const int crease_most_receivers = 1;

crease_receiver crease_make_receiver(ivec2 pixel, vec2 texel, vec3 position, vec3 normal) {
    vec3 to_eye = crease_to_eye(position), tangent, bitangent;
    crease_axes(to_eye, tangent, bitangent);
    mat2 disk = crease_disk(position, tangent, bitangent);
    return crease_receiver(pixel, texel, position, normal, to_eye, tangent, bitangent, disk[0], disk[1]);
}

// From offsets on the disk that faces the eye, in AO radii, to texels; naga reads no struct that holds a matrix.
mat2 crease_disk_of(crease_receiver receiver) { return mat2(receiver.disk_x, receiver.disk_y); }
#ifdef __cplusplus
")glsl"
#endif
