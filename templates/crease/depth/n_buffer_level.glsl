// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
vec4 crease_areas_before(ivec2 texel);
void crease_areas_store(ivec2 texel, vec4 sum);
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
            if (all(lessThan(at, crease_build_size)))
                sum += crease_areas_before(at);
        }
    crease_areas_store(texel, sum);
}
#ifdef __cplusplus
")glsl"
#endif
