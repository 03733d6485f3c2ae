#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// What the samples of a texel kept, each depth once, in groups of four. What is not there is crease_background and
// comes last.

int crease_group_count() { return (crease_stochastic_layers_count + 3) / 4; }

vec4 crease_fetch_group(vec2 texel, int group) {
    ivec3 at = ivec3(ivec2(texel + crease_view.guard), crease_view_index * crease_group_count() + group);
    return texelFetch(crease_packed_layers, at, 0);
}
#ifdef __cplusplus
")glsl"
#endif
