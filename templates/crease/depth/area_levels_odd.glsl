// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// As for levels of even number, but the images change places.
vec4 crease_areas_before(ivec2 texel) { return crease_load_even_levels(ivec3(texel, (crease_areas_level - 1) / 2)); }

void crease_areas_store(ivec2 texel, vec4 sum) {
    imageStore(crease_odd_levels, ivec3(texel, crease_areas_level / 2), sum);
}
#ifdef __cplusplus
")glsl"
#endif
