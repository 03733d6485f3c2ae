#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// Equation (1) of unsharp-mask-ssao by linear depth: with device depth Z = F (d - N) / (d (F - N)),
// 2 N / (F + N - Z (F - N)) is 2 d / (d + F).
float crease_unsharp_mask_far() { return crease_view.far_depth / crease_far_share; }

float crease_unsharp_mask_depth(float depth) {
    float far = crease_unsharp_mask_far();
    float seen = min(depth, far);
    return 2.0 * seen / (seen + far);
}
#ifdef __cplusplus
")glsl"
#endif
