// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
crease_group crease_load_group(vec2 texel, int group);
vec3 crease_unpack_surface_normal(uint word);
#else
__LINE__, R"glsl("
#endif

const int crease_most_layers = crease_compressed_nodes;

const int crease_kept_surfaces = crease_compressed_nodes;

const int crease_first_to_go = crease_compressed_half != 0 ? crease_compressed_nodes / 2 : 0;

// Of a node, whose color is not kept.
crease_surface crease_surface_at(ivec2 texel, int i) {
    crease_group group = crease_load_group(vec2(texel), i / 4);
    uint first = crease_load_compressed_layers(ivec3(texel, i / 4)).w;
    uint second = crease_load_compressed_normals(ivec3(texel, i / 4 * 2)).x;
    uint third = crease_load_compressed_normals(ivec3(texel, i / 4 * 2 + 1)).x;
    uvec4 normals = uvec4(first, first >> 24u | second << 8u, second >> 16u | third << 16u, third >> 8u);
    float opacity = float(group.opacities >> uint(8 * (i % 4)) & 255u) / 255.0;
    return crease_surface(abs(group.depths[i % 4]), crease_unpack_surface_normal(normals[i % 4] & 0xffffffu),
                          vec4(vec3(0.0), opacity));
}
#ifdef __cplusplus
")glsl"
#endif
