// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// The key of a layer of a texel. The latter half holds complements. A last fragment between the others is the nearest and
// the farthest, and counts once.
uint crease_kept_key(ivec2 texel, int layer) {
    uint stored = crease_load_fragment_layers(ivec3(texel, layer)).x;
    int opposite = crease_dual_peeled_layers_layers - 1 - layer;
    if (layer <= opposite || stored == crease_no_fragment)
        return stored;
    return ~stored != crease_load_fragment_layers(ivec3(texel, opposite)).x ? ~stored : crease_no_fragment;
}
#ifdef __cplusplus
")glsl"
#endif
