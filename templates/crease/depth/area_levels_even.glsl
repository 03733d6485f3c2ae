// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// A pass reads one image and writes another, so levels of even number have one and those of odd number the other.
vec4 crease_areas_before(ivec2 texel) { return crease_load_odd_levels(ivec3(texel, (crease_areas_level - 1) / 2)); }

void crease_areas_store(ivec2 texel, vec4 sum) {
    imageStore(crease_even_levels, ivec3(texel, crease_areas_level / 2), sum);
}
#ifdef __cplusplus
")glsl"
#endif
