#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// The share of a volume's chords that lie behind the surface: statistical-volumetric-obscurance 2.3, after Loos and
// Sloan. The lines of a picture count as parallel: a chord weighs as its length in depth. Each counts from what a plane
// through the receiver fills of it.

float crease_depth_rounding(float depth);
float crease_volume_reach(float before);
float crease_volume_occlusion(float filled, float whole);

struct crease_estimate {
    float filled; // length in depth, summed over the chords
    float whole;
    float rounding; // of depth
};

struct crease_contribution {
    float occlusion; // length in depth
    float whole;
};

crease_estimate crease_estimate_begin(crease_receiver receiver) {
    return crease_estimate(0.0, 0.0, crease_depth_rounding(-receiver.position.z));
}

void crease_estimate_turn(inout crease_estimate estimate, vec2 direction) {}

crease_contribution crease_weigh(crease_estimate estimate, crease_receiver receiver, crease_tap tap, vec3 position) {
    float before = position.z - receiver.position.z;
    float whole = max(tap.far - tap.near, 0.0);
    float filled = clamp(tap.far + before - estimate.rounding, 0.0, whole);
    float weight = tap.inside ? tap.weight : 0.0;
    return crease_contribution(weight * (filled - tap.under) * crease_volume_reach(before),
                               weight * (whole - tap.under));
}

void crease_estimate_add(inout crease_estimate estimate, crease_contribution contribution) {
    estimate.filled += contribution.occlusion;
    estimate.whole += contribution.whole;
}

float crease_estimate_occlusion(crease_estimate estimate) {
    return crease_volume_occlusion(estimate.filled, max(estimate.whole, 0.1 * crease_radius)); // less is rounding
}
#ifdef __cplusplus
")glsl"
#endif
