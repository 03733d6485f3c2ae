#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// Range-checked points: stochastic-depth-ao, Algorithm 1. Geometry further than the radius is ignored, as 4.1 says; the
// listing's smoothstep of R / |p.z - d| would leave half of it there at two radii. What hides a point from the eye and is
// out of range says nothing of it.

float crease_depth_rounding(float depth);
float crease_point_bias(crease_receiver receiver);

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

// A point close to the tangent plane says nothing.
bool crease_ssao_over(crease_receiver receiver, crease_tap tap) {
    return dot(tap.offset, receiver.normal) > crease_point_bias(receiver);
}

crease_contribution crease_weigh(crease_estimate estimate, crease_receiver receiver, crease_tap tap, vec3 position) {
    if (!tap.inside || !crease_ssao_over(receiver, tap))
        return crease_contribution(0.0, 0.0);
    float before = position.z - receiver.position.z;
    // Of layers that occlude nothing, one that leaves the point open counts before one that says nothing, and either before
    // none at all.
    if (before - estimate.rounding < tap.offset.z)
        return crease_contribution(position.z > -0.5 * crease_background ? 0.0 : -2e-6, 1.0);
    float in_range = smoothstep(0.0, 1.0, 2.0 * (1.0 - before / crease_radius));
    return crease_contribution(in_range > 0.0 ? in_range : -1e-6, in_range);
}

void crease_estimate_add(inout crease_estimate estimate, crease_contribution contribution) {
    estimate.occluded += contribution.occlusion;
    estimate.points += contribution.points;
}

float crease_estimate_occlusion(crease_estimate estimate) { return estimate.occluded / max(estimate.points, 1.0); }
#ifdef __cplusplus
")glsl"
#endif
