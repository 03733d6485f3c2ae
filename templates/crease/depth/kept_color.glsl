// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// The color of a fragment, packed, where nothing reads normals.
uvec2 crease_fragment_surface(ivec2 texel, uint place) {
    return uvec2(crease_load_fragment_surfaces(ivec3(texel, place)).x, 0u);
}
#ifdef __cplusplus
")glsl"
#endif
