// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// The color and the normal of a fragment, packed.
uvec2 crease_fragment_surface(ivec2 texel, uint place) {
    return uvec2(crease_load_fragment_surfaces(ivec3(texel, place)).x,
                 crease_load_fragment_surfaces(ivec3(texel, crease_most_surfaces + int(place))).x);
}
#ifdef __cplusplus
")glsl"
#endif
