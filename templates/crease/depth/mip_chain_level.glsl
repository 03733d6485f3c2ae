// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
vec4 crease_areas_before(ivec2 texel);
void crease_areas_store(ivec2 texel, vec4 sum);
#else
__LINE__, R"glsl("
#endif

// A level of a mip chain holds the sums over squares of four texels of the level before, in a corner of its image:
// statistical-volumetric-obscurance 3.3, figure 3.2.
void crease_build(ivec2 texel) {
    const int before = crease_areas_level - 1;
    ivec2 size = (crease_build_size + (1 << before) - 1) >> before;
    if (any(greaterThanEqual(2 * texel, size)))
        return;
    vec4 sum = vec4(0.0);
    crease_unroll for (int j = 0; j < 2; ++j)
        crease_unroll for (int i = 0; i < 2; ++i) {
            ivec2 at = 2 * texel + ivec2(i, j);
            if (all(lessThan(at, size)))
                sum += crease_areas_before(at);
        }
    crease_areas_store(texel, sum);
}
#ifdef __cplusplus
")glsl"
#endif
