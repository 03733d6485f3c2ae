// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
float crease_depth_rounding(float depth);
float crease_eye_side(crease_receiver receiver);
float crease_layer_before(crease_receiver receiver, crease_layer layer);
float crease_point_bias(crease_receiver receiver, float bias);
float crease_volume_reach(float before, float falloff);
float crease_volume_occlusion(float filled, float whole);
#else
__LINE__, R"glsl("
#endif

// The share of a volume's points that lie behind the surface: statistical-volumetric-obscurance 2.2 and (4.1), where
// the density of the sampler's points is the weight of a place. Each counts from what a plane through the receiver does
// with it, as of a few points half are not behind that.
struct crease_estimate {
    float occluded; // points
    float points;
};

struct crease_march {
    float occluded;
    float points;
    float rounding; // of depth
};

struct crease_contribution {
    float occlusion;
    float points;
};

crease_estimate crease_estimate_begin(crease_receiver receiver) { return crease_estimate(0.0, 0.0); }

crease_march crease_begin_direction(crease_estimate estimate, crease_receiver receiver, vec2 direction) {
    return crease_march(0.0, 0.0, crease_depth_rounding(-receiver.position.z));
}

crease_contribution crease_weigh(crease_march march, crease_receiver receiver, crease_tap tap, crease_layer layer) {
    float height = dot(tap.offset, receiver.normal);
    if (!tap.inside || abs(height) <= crease_point_bias(receiver, crease_point_volume_bias))
        return crease_contribution(0.0, 0.0);
    float before = crease_layer_before(receiver, layer);
    float under = height < 0.0 ? 1.0 : 0.0;
    float margin = height < 0.0 ? -march.rounding : march.rounding;
    float filled = before - margin > crease_eye_side(receiver) * tap.offset.z ? 1.0 : 0.0;
    float reach = crease_volume_reach(before, crease_point_volume_falloff);
    return crease_contribution((filled - under) * reach, 1.0 - under);
}

void crease_add(inout crease_march march, crease_contribution contribution) {
    march.occluded += contribution.occlusion;
    march.points += contribution.points;
}

void crease_end_direction(inout crease_estimate estimate, crease_march march) {
    estimate.occluded += march.occluded;
    estimate.points += march.points;
}

float crease_estimate_occlusion(crease_estimate estimate) {
    return crease_volume_occlusion(estimate.occluded, max(estimate.points, 1.0));
}
#ifdef __cplusplus
")glsl"
#endif
