// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

crease_fragments crease_sorted_fragments(ivec2 texel) {
    uint of_static = crease_load_fragment_layers(ivec3(texel, 0)).x,
         of_dynamic = crease_load_fragment_layers(ivec3(texel, 1)).x, nearer = of_dynamic < of_static ? 1u : 0u;
    crease_fragments sorted;
    sorted.keys[0] = min(of_static, of_dynamic);
    sorted.keys[1] = max(of_static, of_dynamic);
    sorted.places[0] = nearer;
    sorted.places[1] = 1u - nearer;
    return sorted;
}
#ifdef __cplusplus
")glsl"
#endif
