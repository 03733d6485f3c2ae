#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// The share of a volume's chords that lie behind the surface: statistical-volumetric-obscurance 2.3, after Loos and
// Sloan. The lines of a picture count as parallel: a chord weighs as its length in depth.

float crease_volume_reach(crease_receiver receiver, float depth);
float crease_volume_occlusion(float filled, float whole);

struct crease_estimate {
    float filled; // length in depth, summed over the chords
    float whole;
};

struct crease_contribution {
    float occlusion; // length in depth
    float whole;
};

crease_estimate crease_estimate_begin(crease_receiver receiver) { return crease_estimate(0.0, 0.0); }

void crease_estimate_turn(inout crease_estimate estimate, vec2 direction) {}

crease_contribution crease_weigh(crease_estimate estimate, crease_receiver receiver, crease_tap tap, vec3 position) {
    float depth = -position.z;
    float whole = max(tap.far - tap.near, 0.0);
    float filled = clamp(tap.far - depth, 0.0, whole);
    return tap.inside ? crease_contribution(filled * crease_volume_reach(receiver, depth), whole)
                      : crease_contribution(0.0, 0.0);
}

void crease_estimate_add(inout crease_estimate estimate, crease_contribution contribution) {
    estimate.filled += contribution.occlusion;
    estimate.whole += contribution.whole;
}

float crease_estimate_occlusion(crease_estimate estimate) {
    return crease_volume_occlusion(estimate.filled, estimate.whole);
}
#ifdef __cplusplus
")glsl"
#endif
