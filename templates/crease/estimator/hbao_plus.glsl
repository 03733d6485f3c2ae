#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// Taps projected onto the normal: stochastic-depth-ao, Algorithm 3.

struct crease_estimate {
    float occlusion; // summed over the taps
    float weights;
    float reach;     // 1 / square of the radius
};

struct crease_contribution {
    float occlusion;
    float rise; // cosine between the normal and the way to the tap less the bias, where that occludes
    float weight;
};

crease_estimate crease_estimate_begin(crease_receiver receiver) {
    return crease_estimate(0.0, 0.0, 1.0 / (crease_radius * crease_radius));
}

void crease_estimate_turn(inout crease_estimate estimate, vec2 direction) {}

crease_contribution crease_weigh(crease_estimate estimate, crease_receiver receiver, crease_tap tap, vec3 position) {
    vec3 to_tap = position - receiver.position;
    float squared = dot(to_tap, to_tap);
    float rise = dot(to_tap, receiver.normal) * inversesqrt(squared) - crease_bias;
    float falloff = 1.0 - squared * estimate.reach;
    bool counts = tap.inside && falloff > 0.0 && rise > 0.0;
    float weight = tap.inside ? tap.weight : 0.0;
    return counts ? crease_contribution(weight * falloff * rise, rise, weight) : crease_contribution(0.0, 0.0, weight);
}

void crease_estimate_add(inout crease_estimate estimate, crease_contribution contribution) {
    estimate.occlusion += contribution.occlusion;
    estimate.weights += contribution.weight;
}

float crease_estimate_occlusion(crease_estimate estimate) { return estimate.occlusion / max(estimate.weights, 1e-20); }
#ifdef __cplusplus
")glsl"
#endif
