#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// Range-checked points: stochastic-depth-ao, Algorithm 1.

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

// A point close to the tangent plane says nothing, as rounding may put it behind the surface.
bool crease_ssao_over(crease_receiver receiver, crease_tap tap) {
    return dot(tap.point - receiver.position, receiver.normal) > crease_bias * crease_radius;
}

crease_contribution crease_weigh(crease_estimate estimate, crease_receiver receiver, crease_tap tap, vec3 position) {
    if (!tap.inside || !crease_ssao_over(receiver, tap))
        return crease_contribution(0.0, 0.0);
    float apart = abs(receiver.position.z - position.z);
    float in_range = smoothstep(0.0, 1.0, crease_radius / max(apart, 1e-20));
    return crease_contribution(position.z >= tap.point.z ? in_range : 0.0, 1.0);
}

void crease_estimate_add(inout crease_estimate estimate, crease_contribution contribution) {
    estimate.occluded += contribution.occlusion;
    estimate.points += contribution.points;
}

float crease_estimate_occlusion(crease_estimate estimate) { return estimate.occluded / max(estimate.points, 1.0); }
#ifdef __cplusplus
")glsl"
#endif
