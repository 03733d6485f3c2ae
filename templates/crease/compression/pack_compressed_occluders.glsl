// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
float crease_fragment_depth(uint key);
uvec2 crease_fragment_surface(ivec2 texel, uint place);
void crease_add_node(inout crease_nodes nodes, float depth, uvec2 surface);
crease_nodes crease_begin_nodes();
void crease_store_nodes(ivec2 texel, crease_nodes nodes);
#else
__LINE__, R"glsl("
#endif

// For taps nodes, and for receivers all surfaces.
void crease_pack_fragments(ivec2 texel, crease_fragments sorted) {
    crease_nodes nodes = crease_begin_nodes();
    bool there = true;
    crease_unroll for (int i = 0; i < crease_most_surfaces; ++i)
        if (there) {
            float depth = crease_fragment_depth(sorted.keys[i]);
            there = depth < crease_background;
            uvec2 surface = there ? crease_fragment_surface(texel, sorted.places[i]) : uvec2(0u);
            if (there)
                crease_add_node(nodes, depth, surface);
            imageStore(crease_layer_surfaces, ivec3(texel, i), uvec4(floatBitsToUint(depth), surface, 0u));
        }
    crease_store_nodes(texel, nodes);
}
#ifdef __cplusplus
")glsl"
#endif
