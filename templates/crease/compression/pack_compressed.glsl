// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
int crease_group_count();
crease_nodes crease_compress(ivec2 texel, crease_fragments sorted);
void crease_store_nodes(ivec2 texel, crease_nodes nodes);
#else
__LINE__, R"glsl("
#endif

// Of a group the normals, of which the first and a third of the second are in a word that taps read.
void crease_store_normals(ivec2 texel, crease_nodes nodes) {
    crease_unroll for (int i = 0; i < 4 * crease_group_count(); i += 4) {
        uvec3 normals = uvec3(nodes.surfaces[i + 1].y, nodes.surfaces[i + 2].y, nodes.surfaces[i + 3].y);
        imageStore(crease_compressed_normals, ivec3(texel, i / 2), uvec4(normals.x >> 8u | normals.y << 16u));
        imageStore(crease_compressed_normals, ivec3(texel, i / 2 + 1), uvec4(normals.y >> 16u | normals.z << 8u));
    }
}

void crease_pack_fragments(ivec2 texel, crease_fragments sorted) {
    crease_nodes nodes = crease_compress(texel, sorted);
    crease_store_nodes(texel, nodes);
    crease_store_normals(texel, nodes);
}
#ifdef __cplusplus
")glsl"
#endif
