#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// The texels of the table of the whole picture, before they are summed.

vec4 crease_area_texel(ivec2 at);

void crease_build(ivec2 texel) { imageStore(crease_area_tables, ivec3(texel, 0), crease_area_texel(texel)); }
#ifdef __cplusplus
")glsl"
#endif
