#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// The depth less its mean over a window: unsharp-mask-ssao's listing. As the mean is of depths, the listing's lower
// bound of 0 on it never acts, and the difference is the mean of the differences, which is exact where all are alike.

struct crease_estimate {
    float far;   // of the view
    float depth; // of the receiver, by (1)
    float rise;  // of the receiver over its neighbours, summed
    float neighbours;
};

struct crease_contribution {
    float occlusion;
    float neighbours;
};

// Equation (1) by linear depth: with device depth Z = F (d - N) / (d (F - N)), 2 N / (F + N - Z (F - N)) is
// 2 d / (d + F).
float crease_unsharp_mask_depth(float depth, float far) {
    float seen = min(depth, far);
    return 2.0 * seen / (seen + far);
}

crease_estimate crease_estimate_begin(crease_receiver receiver) {
    float far = crease_view.far_depth / crease_far_share;
    return crease_estimate(far, crease_unsharp_mask_depth(-receiver.position.z, far), 0.0, 0.0);
}

void crease_estimate_turn(inout crease_estimate estimate, vec2 direction) {}

crease_contribution crease_weigh(crease_estimate estimate, crease_receiver receiver, crease_tap tap, vec3 position) {
    float rise = estimate.depth - crease_unsharp_mask_depth(-position.z, estimate.far);
    return abs(rise) < crease_threshold ? crease_contribution(rise, 1.0) : crease_contribution(0.0, 0.0);
}

void crease_estimate_add(inout crease_estimate estimate, crease_contribution contribution) {
    estimate.rise += contribution.occlusion;
    estimate.neighbours += contribution.neighbours;
}

float crease_estimate_occlusion(crease_estimate estimate) { return estimate.rise / max(estimate.neighbours, 1.0); }
#ifdef __cplusplus
")glsl"
#endif
