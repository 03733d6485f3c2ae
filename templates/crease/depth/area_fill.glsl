#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// The texels that the levels above them are made of.

vec4 crease_area_texel(ivec2 at);

void crease_build(ivec2 texel) { imageStore(crease_area_tables, ivec3(texel, 0), crease_area_texel(texel)); }
#ifdef __cplusplus
")glsl"
#endif
