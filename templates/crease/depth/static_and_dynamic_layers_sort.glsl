// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// Of equal ones there is one.
crease_fragments crease_sorted_fragments(ivec2 texel) {
    uint of_static = crease_load_fragment_layers(ivec3(texel, 0)).x,
         of_dynamic = crease_load_fragment_layers(ivec3(texel, 1)).x;
    crease_fragments sorted;
    sorted.keys[0] = min(of_static, of_dynamic);
    sorted.keys[1] = of_static != of_dynamic ? max(of_static, of_dynamic) : crease_no_fragment;
    return sorted;
}
#ifdef __cplusplus
")glsl"
#endif
