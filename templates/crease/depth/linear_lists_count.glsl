// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// Counts the fragments of a texel, so that its list gets as many nodes: a-buffer-ssao 2013, IV.B.

// Called by the host's fragment shader, after its own alpha test. `anchor`: the position on the surface, as other
// captures take it.
void crease_capture(vec3 anchor) { imageAtomicAdd(crease_list_places, ivec3(gl_FragCoord.xy, 0), 1u); }
#ifdef __cplusplus
")glsl"
#endif
