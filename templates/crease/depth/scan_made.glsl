// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
vec4 crease_area_texel(ivec2 at);
#else
__LINE__, R"glsl("
#endif

// A scan that makes the texels of the whole picture's table as it reads them: twice, which costs less than a pass that
// stores them.
vec4 crease_scan_read(ivec3 at) { return crease_area_texel(at.xy); }
#ifdef __cplusplus
")glsl"
#endif
