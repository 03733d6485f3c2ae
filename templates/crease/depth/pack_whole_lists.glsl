// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
float crease_fragment_depth(uint key);
uvec2 crease_fragment_surface(ivec2 texel, uint place);
#else
__LINE__, R"glsl("
#endif

// What taps read, and apart from that what receivers read.
void crease_pack_fragments(ivec2 texel, crease_fragments sorted) {
    crease_group group = crease_no_group;
    bool there = true, is_stored = true;
    crease_unroll for (int i = 0; i < crease_most_surfaces; ++i) {
        if (i % 4 == 0) {
            group = crease_no_group;
            is_stored = there;
        }
        float depth = crease_fragment_depth(sorted.keys[i]);
        bool ends = !(depth < crease_background);
        uvec2 surface = ends ? uvec2(0xff000000u, 0u) : crease_fragment_surface(texel, sorted.places[i]);
        if (there)
            imageStore(crease_layer_surfaces, ivec3(texel, i), uvec4(floatBitsToUint(depth), surface, 0u));
        group.depths[i % 4] = depth;
        group.opacities = group.opacities & ~(255u << uint(8 * (i % 4))) | surface.x >> 24u << uint(8 * (i % 4));
        if (is_stored && (i % 4 == 3 || i + 1 == crease_most_surfaces)) {
            imageStore(crease_packed_layers, ivec3(texel, i / 4), group.depths);
            imageStore(crease_packed_opacities, ivec3(texel, i / 4), uvec4(group.opacities));
        }
        there = there && !ends;
    }
}
#ifdef __cplusplus
")glsl"
#endif
