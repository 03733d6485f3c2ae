#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// What the samples of a texel kept, each depth once, in groups of four; crease_background after the last. A group is
// there where the one before it is full.

int crease_group_count();

vec4 crease_fetch_group(vec2 texel, int group) {
    // The image is as large as the first camera asks, also where the second is smaller.
    vec2 at = (texel + crease_view.guard) / vec2(textureSize(crease_packed_layers, 0).xy);
    int index = crease_view_index * crease_group_count() + group;
    return textureLod(crease_packed_layers, vec3(at, float(index)), 0.0);
}
#ifdef __cplusplus
")glsl"
#endif
