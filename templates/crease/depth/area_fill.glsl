// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
vec4 crease_area_texel(ivec2 at);
#else
__LINE__, R"glsl("
#endif

// Level 0 of a pyramid, of which the levels above are made.
void crease_build(ivec2 texel) { imageStore(crease_even_levels, ivec3(texel, 0), crease_area_texel(texel)); }
#ifdef __cplusplus
")glsl"
#endif
