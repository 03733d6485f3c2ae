// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// The normal in what passes hand on: none, where no filter weighs by it.
uint crease_pack_normal(vec3 normal) { return 0u; }

vec3 crease_unpack_normal(uint word) { return vec3(0.0); }
#ifdef __cplusplus
")glsl"
#endif
