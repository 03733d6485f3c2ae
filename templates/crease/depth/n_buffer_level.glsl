// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
vec4 crease_areas_at(ivec3 texel);
ivec2 crease_areas_size();
#else
__LINE__, R"glsl("
#endif

// A level of an N-buffer holds the sums over squares, twice as wide as those of the level before, that begin at each
// texel: statistical-volumetric-obscurance 3.3, figure 3.2.
void crease_build(ivec2 texel) {
    const int before = crease_areas_level - 1;
    vec4 sum = vec4(0.0);
    crease_unroll for (int j = 0; j < 2; ++j)
        crease_unroll for (int i = 0; i < 2; ++i) {
            ivec2 at = texel + (ivec2(i, j) << before);
            if (all(lessThan(at, crease_areas_size())))
                sum += crease_areas_at(ivec3(at, before));
        }
    imageStore(crease_area_tables, ivec3(texel, crease_areas_level), sum);
}
#ifdef __cplusplus
")glsl"
#endif
