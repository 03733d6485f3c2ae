#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// The share of taps that rise over the tangent plane, each weighed by how near it is.

struct crease_estimate {
    float occlusion; // summed over the taps
    float weights;
};

struct crease_contribution {
    float occlusion; // the layer of a tap that has the most counts
    float weight;    // 0 where the tap lies outside the depth image
};

crease_estimate crease_estimate_begin(crease_receiver receiver) { return crease_estimate(0.0, 0.0); }

void crease_estimate_turn(inout crease_estimate estimate, vec2 direction) {}

crease_contribution crease_weigh(crease_estimate estimate, crease_receiver receiver, crease_tap tap, vec3 position) {
    vec3 to_tap = position - receiver.position;
    bool above = dot(to_tap, receiver.normal) > crease_bias * crease_radius;
    float weight = tap.inside ? tap.weight : 0.0;
    return crease_contribution(above ? weight * max(1.0 - length(to_tap) / crease_radius, 0.0) : 0.0, weight);
}

void crease_estimate_add(inout crease_estimate estimate, crease_contribution contribution) {
    estimate.occlusion += contribution.occlusion;
    estimate.weights += contribution.weight;
}

float crease_estimate_occlusion(crease_estimate estimate) { return estimate.occlusion / max(estimate.weights, 1e-20); }
#ifdef __cplusplus
")glsl"
#endif
