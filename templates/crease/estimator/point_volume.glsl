#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// The share of a volume's points that lie behind the surface: statistical-volumetric-obscurance 2.2 and (4.1), where
// the density of the sampler's points is the weight of a place. Each counts from what a plane through the receiver does
// with it, as of a few points half are not behind that.

float crease_depth_rounding(float depth);
float crease_point_bias(crease_receiver receiver);
float crease_volume_reach(float before);
float crease_volume_occlusion(float filled, float whole);

struct crease_estimate {
    float occluded; // points
    float points;
    float rounding; // of depth
};

struct crease_contribution {
    float occlusion;
    float points;
};

crease_estimate crease_estimate_begin(crease_receiver receiver) {
    return crease_estimate(0.0, 0.0, crease_depth_rounding(-receiver.position.z));
}

void crease_estimate_turn(inout crease_estimate estimate, vec2 direction) {}

crease_contribution crease_weigh(crease_estimate estimate, crease_receiver receiver, crease_tap tap, vec3 position) {
    float height = dot(tap.offset, receiver.normal);
    if (!tap.inside || abs(height) <= crease_point_bias(receiver))
        return crease_contribution(0.0, 0.0);
    float before = position.z - receiver.position.z;
    float under = height < 0.0 ? 1.0 : 0.0;
    float margin = height < 0.0 ? -estimate.rounding : estimate.rounding;
    float filled = before - margin > tap.offset.z ? 1.0 : 0.0;
    return crease_contribution((filled - under) * crease_volume_reach(before), 1.0 - under);
}

void crease_estimate_add(inout crease_estimate estimate, crease_contribution contribution) {
    estimate.occluded += contribution.occlusion;
    estimate.points += contribution.points;
}

float crease_estimate_occlusion(crease_estimate estimate) {
    return crease_volume_occlusion(estimate.occluded, max(estimate.points, 1.0));
}
#ifdef __cplusplus
")glsl"
#endif
