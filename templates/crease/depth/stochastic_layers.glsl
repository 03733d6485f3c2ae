#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// What the samples of a texel kept, each depth once, in groups of four; crease_background after the last. A group is
// there where the one before it is full.

int crease_group_count();

// Of a texel inside the depth image.
vec4 crease_fetch_group(vec2 texel, int group) {
    int index = crease_view_index * crease_group_count() + group;
    return imageLoad(crease_packed_layers, ivec3(texel, index));
}
#ifdef __cplusplus
")glsl"
#endif
