// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
float crease_depth_rounding(float depth);
float crease_eye_side(crease_receiver receiver);
float crease_layer_before(crease_receiver receiver, crease_layer layer);
float crease_volume_reach(float before, float falloff);
float crease_volume_occlusion(float filled, float whole);
#else
__LINE__, R"glsl("
#endif

// The share of a volume's chords that lie behind the surface: statistical-volumetric-obscurance 2.3, after Loos and
// Sloan. The lines of a picture count as parallel: a chord weighs as its length in depth. Each counts from what a plane
// through the receiver fills of it.
struct crease_estimate {
    float filled; // length in depth, summed over the chords
    float whole;
};

struct crease_march {
    float filled;
    float whole;
    float rounding; // of depth
};

struct crease_contribution {
    float occlusion; // length in depth
    float whole;
};

crease_estimate crease_estimate_begin(crease_receiver receiver) { return crease_estimate(0.0, 0.0); }

crease_march crease_begin_direction(crease_estimate estimate, crease_receiver receiver, vec2 direction) {
    return crease_march(0.0, 0.0, crease_depth_rounding(-receiver.position.z));
}

crease_contribution crease_weigh(crease_march march, crease_receiver receiver, crease_tap tap, crease_layer layer) {
    float before = crease_layer_before(receiver, layer);
    float end = crease_eye_side(receiver) > 0.0 ? tap.far : -tap.near; // that is farther from the eye
    float whole = max(tap.far - tap.near, 0.0);
    float filled = clamp(end + before - march.rounding, 0.0, whole);
    float weight = tap.inside ? tap.weight : 0.0;
    float reach = crease_volume_reach(before, crease_line_volume_falloff);
    return crease_contribution(weight * (filled - tap.under) * reach, weight * (whole - tap.under));
}

void crease_add(inout crease_march march, crease_contribution contribution) {
    march.filled += contribution.occlusion;
    march.whole += contribution.whole;
}

void crease_end_direction(inout crease_estimate estimate, crease_march march) {
    estimate.filled += march.filled;
    estimate.whole += march.whole;
}

float crease_estimate_occlusion(crease_estimate estimate) {
    return crease_volume_occlusion(estimate.filled, max(estimate.whole, 0.1 * crease_radius)); // less is rounding
}
#ifdef __cplusplus
")glsl"
#endif
