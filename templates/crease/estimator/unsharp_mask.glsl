#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// The depth less its mean over a window: unsharp-mask-ssao's listing. As the mean is of depths, the listing's lower
// bound of 0 on it never acts, and the difference is the mean of the differences, which is exact where all are alike.

float crease_unsharp_mask_depth(float depth);

struct crease_estimate {
    float depth; // of the receiver, by (1)
    float rise;  // of the receiver over its neighbours, summed
    float texels;
};

struct crease_contribution {
    float occlusion;
    float texels;
};

crease_estimate crease_estimate_begin(crease_receiver receiver) {
    return crease_estimate(crease_unsharp_mask_depth(-receiver.position.z), 0.0, 0.0);
}

void crease_estimate_turn(inout crease_estimate estimate, vec2 direction) {}

crease_contribution crease_weigh(crease_estimate estimate, crease_receiver receiver, crease_tap tap, vec3 position) {
    float rise = estimate.depth - crease_unsharp_mask_depth(-position.z);
    bool counts = tap.inside && abs(rise) < crease_threshold;
    return counts ? crease_contribution(rise, 1.0) : crease_contribution(0.0, 0.0);
}

void crease_estimate_add(inout crease_estimate estimate, crease_contribution contribution) {
    estimate.rise += contribution.occlusion;
    estimate.texels += contribution.texels;
}

float crease_estimate_occlusion(crease_estimate estimate) { return estimate.rise / max(estimate.texels, 1.0); }
#ifdef __cplusplus
")glsl"
#endif
