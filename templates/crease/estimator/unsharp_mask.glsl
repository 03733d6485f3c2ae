// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

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

// The depth less its mean over a window: unsharp-mask-ssao's listing. As the mean is of depths, the listing's lower
// bound of 0 on it never acts, and the difference is the mean of the differences, which is exact where all are alike.
struct crease_estimate {
    float rise; // of the receiver over its neighbours, summed
    float texels;
};

struct crease_march {
    float rise;
    float texels;
    float depth; // of the receiver, by (1)
};

struct crease_contribution {
    float occlusion;
    float texels;
};

crease_estimate crease_estimate_begin(crease_receiver receiver) { return crease_estimate(0.0, 0.0); }

crease_march crease_begin_direction(crease_estimate estimate, crease_receiver receiver, vec2 direction) {
    return crease_march(0.0, 0.0, crease_unsharp_mask_depth(-receiver.position.z));
}

crease_contribution crease_weigh(crease_march march, crease_receiver receiver, crease_tap tap, crease_layer layer) {
    float rise = march.depth - crease_unsharp_mask_depth(-layer.position.z);
    bool counts = tap.inside && abs(rise) < crease_unsharp_mask_threshold;
    return crease_contribution(counts ? layer.texels * rise : 0.0, counts ? layer.texels : 0.0);
}

void crease_add(inout crease_march march, crease_contribution contribution) {
    march.rise += contribution.occlusion;
    march.texels += contribution.texels;
}

void crease_end_direction(inout crease_estimate estimate, crease_march march) {
    estimate.rise += march.rise;
    estimate.texels += march.texels;
}

float crease_estimate_occlusion(crease_estimate estimate) { return estimate.rise / max(estimate.texels, 1.0); }

// Means over areas are of the depth of (1), less that of the picture's mean depth, so that sums stay small; background
// lies at the far plane, and where there is none it is in no mean.

float crease_area_depth(float depth) {
    bool counts = depth > 0.0 && (depth < crease_background || !crease_unsharp_mask_endless());
    return counts ? min(depth, crease_unsharp_mask_far()) : 0.0;
}

vec3 crease_area_value(vec3 position, float centre) {
    return vec3(crease_unsharp_mask_depth(centre) - crease_unsharp_mask_depth(-position.z), 0.0, 0.0);
}

vec3 crease_area_position(vec3 value, float centre) {
    float seen = crease_unsharp_mask_depth(centre) - value.x;
    float depth = crease_unsharp_mask_endless() ? 0.5 * crease_unsharp_mask_scale() * seen
                                                : seen * crease_unsharp_mask_far() / (2.0 - seen);
    return vec3(0.0, 0.0, -depth);
}
#ifdef __cplusplus
")glsl"
#endif
