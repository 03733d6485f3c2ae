// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
crease_result crease_weighted(crease_result result, float weight);
crease_result crease_sum(crease_result a, crease_result b);
#else
__LINE__, R"glsl("
#endif

// Adds what is seen of a surface to that of the surfaces before it.
crease_result crease_blend(crease_result before, crease_result own, vec3 color, float share) {
    return crease_sum(before, crease_weighted(own, share));
}
#ifdef __cplusplus
")glsl"
#endif
