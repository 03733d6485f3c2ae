// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// Of two contributions of a tap the greater one: stochastic-depth-ao 6.2, a-buffer-ssao III A.
crease_contribution crease_combine(crease_contribution a, crease_contribution b) {
    if (b.occlusion > a.occlusion)
        a = b;
    return a;
}
#ifdef __cplusplus
")glsl"
#endif
