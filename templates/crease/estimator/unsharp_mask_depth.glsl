#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// Equation (1) of unsharp-mask-ssao by linear depth: with device depth Z = F (d - N) / (d (F - N)),
// 2 N / (F + N - Z (F - N)) is 2 d / (d + F). As F grows that tends to 2 d / F, which is taken where there is no far
// plane, for an F of 100 AO radii: the paper's threshold of 0.02 is then one radius.
float crease_unsharp_mask_scale() { return 100.0 * max(crease_radius, 1e-20); }

float crease_unsharp_mask_far() { return crease_view.far_depth / crease_far_share; }

bool crease_unsharp_mask_endless() { return crease_unsharp_mask_far() > 0.5 * crease_background; }

float crease_unsharp_mask_depth(float depth) {
    float far = crease_unsharp_mask_far();
    float seen = min(depth, far);
    return 2.0 * seen / (crease_unsharp_mask_endless() ? crease_unsharp_mask_scale() : seen + far);
}
#ifdef __cplusplus
")glsl"
#endif
