// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// The levels of a pyramid, as the main pass reads them.
vec4 crease_areas_at(ivec3 texel) {
    ivec3 at = ivec3(texel.xy, texel.z / 2);
    return texel.z % 2 == 0 ? crease_load_even_levels(at) : crease_load_odd_levels(at);
}

ivec2 crease_areas_size() { return crease_size_of_even_levels(); }
#ifdef __cplusplus
")glsl"
#endif
