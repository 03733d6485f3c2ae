#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// The share of a volume's points that lie behind the surface: statistical-volumetric-obscurance 2.2 and (4.1), where
// the density of the sampler's points is the weight of a place.

float crease_volume_reach(crease_receiver receiver, float depth);
float crease_volume_occlusion(float filled, float whole);

struct crease_estimate {
    float occluded; // points
    float points;
};

struct crease_contribution {
    float occlusion;
    float points;
};

crease_estimate crease_estimate_begin(crease_receiver receiver) { return crease_estimate(0.0, 0.0); }

void crease_estimate_turn(inout crease_estimate estimate, vec2 direction) {}

crease_contribution crease_weigh(crease_estimate estimate, crease_receiver receiver, crease_tap tap, vec3 position) {
    bool filled = tap.inside && position.z > tap.point.z + crease_bias * crease_radius;
    return crease_contribution(filled ? crease_volume_reach(receiver, -position.z) : 0.0, float(tap.inside));
}

void crease_estimate_add(inout crease_estimate estimate, crease_contribution contribution) {
    estimate.occluded += contribution.occlusion;
    estimate.points += contribution.points;
}

float crease_estimate_occlusion(crease_estimate estimate) {
    return crease_volume_occlusion(estimate.occluded, estimate.points);
}
#ifdef __cplusplus
")glsl"
#endif
