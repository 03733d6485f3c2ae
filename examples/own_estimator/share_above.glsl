#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// The share of taps that rise over the tangent plane, each weighed by how near it is.

struct crease_estimate {
    float occlusion; // summed over the taps
    float taps;
};

struct crease_contribution {
    float occlusion; // the layer of a tap that has the most counts
    float taps;      // 0 where the tap lies outside the depth image, else 1
};

crease_estimate crease_estimate_begin(crease_receiver receiver) { return crease_estimate(0.0, 0.0); }

void crease_estimate_turn(inout crease_estimate estimate, vec2 direction) {}

crease_contribution crease_weigh(crease_estimate estimate, crease_receiver receiver, crease_tap tap, vec3 position) {
    vec3 to_tap = position - receiver.position;
    bool above = tap.inside && dot(to_tap, receiver.normal) > crease_bias * crease_radius;
    return crease_contribution(above ? max(1.0 - length(to_tap) / crease_radius, 0.0) : 0.0, float(tap.inside));
}

void crease_estimate_add(inout crease_estimate estimate, crease_contribution contribution) {
    estimate.occlusion += contribution.occlusion;
    estimate.taps += contribution.taps;
}

float crease_estimate_occlusion(crease_estimate estimate) { return estimate.occlusion / max(estimate.taps, 1.0); }
#ifdef __cplusplus
")glsl"
#endif
