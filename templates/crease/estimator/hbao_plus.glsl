// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
vec3 crease_to_eye(vec3 position);
crease_open crease_turned_normal(crease_receiver receiver, vec2 direction, float cosine, float sine);
#else
__LINE__, R"glsl("
#endif

// Taps projected onto the normal: stochastic-depth-ao, Algorithm 3.
struct crease_estimate {
    float occlusion; // summed over the taps
    float weights;
    float reach;     // 1 / square of the radius
};

// A direction.
struct crease_march {
    float occlusion;
    float weights;
    float highest; // cosine between the normal and the way to a layer less the bias, where that occludes
    float reach;
};

struct crease_contribution {
    float occlusion;
    float highest;
    float weight;
};

crease_estimate crease_estimate_begin(crease_receiver receiver) {
    return crease_estimate(0.0, 0.0, 1.0 / (crease_radius * crease_radius));
}

crease_march crease_begin_direction(crease_estimate estimate, crease_receiver receiver, vec2 direction) {
    return crease_march(0.0, 0.0, 0.0, estimate.reach);
}

crease_contribution crease_weigh(crease_march march, crease_receiver receiver, crease_tap tap, crease_layer layer) {
    vec3 to_layer = layer.position - receiver.position;
    float squared = dot(to_layer, to_layer);
    float rise = dot(to_layer, receiver.normal) * inversesqrt(squared) - crease_hbao_plus_bias;
    float falloff = 1.0 - squared * march.reach;
    bool counts = tap.inside && falloff > 0.0 && rise > 0.0;
    float weight = tap.inside ? tap.weight : 0.0;
    return crease_contribution(counts ? weight * falloff * rise : 0.0, counts ? rise : 0.0, weight);
}

crease_contribution crease_fade(crease_march march, crease_receiver receiver, crease_tap tap,
                                crease_contribution contribution, float opacity) {
    return crease_contribution(contribution.occlusion * opacity, contribution.highest * opacity, contribution.weight);
}

// If the front layer lies below the tangent plane and the ray of its texel goes further down, so do all layers behind
// it.
bool crease_skip_behind(crease_march march, crease_receiver receiver, crease_tap tap, crease_layer front) {
    return !(dot(front.position - receiver.position, receiver.normal) > 0.0) &&
        dot(crease_to_eye(front.position), receiver.normal) >= 0.0;
}

void crease_add(inout crease_march march, crease_contribution contribution) {
    march.occlusion += contribution.occlusion;
    march.weights += contribution.weight;
    march.highest = max(march.highest, contribution.highest);
}

// Layers behind count by how much more they occlude.
void crease_add_behind(inout crease_march march, crease_contribution front, crease_contribution behind) {
    march.occlusion += max(behind.occlusion - front.occlusion, 0.0);
    march.highest = max(march.highest, behind.highest);
}

void crease_end_direction(inout crease_estimate estimate, crease_march march) {
    estimate.occlusion += march.occlusion;
    estimate.weights += march.weights;
}

// The normal, turned away from the highest layer by its angle over the tangent plane: stochastic-depth-ao 7.1, the form
// with lambda.
crease_open crease_open_direction(crease_march march, crease_receiver receiver, vec2 direction) {
    float sine = min(march.highest, 1.0);
    return crease_turned_normal(receiver, direction, sqrt(1.0 - sine * sine), sine);
}

float crease_estimate_occlusion(crease_estimate estimate) { return estimate.occlusion / max(estimate.weights, 1e-20); }
#ifdef __cplusplus
")glsl"
#endif
