// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
float crease_depth_rounding(float depth);
float crease_eye_side(crease_receiver receiver);
float crease_layer_before(crease_receiver receiver, crease_layer layer);
float crease_point_bias(crease_receiver receiver, float bias);
#else
__LINE__, R"glsl("
#endif

// Range-checked points: stochastic-depth-ao, Algorithm 1. Geometry further than the radius is ignored, as 4.1 says; the
// listing's smoothstep of R / |p.z - d| would leave half of it there at two radii. What hides a point from the eye and
// is out of range says nothing of it.
struct crease_estimate {
    float occluded; // points
    float points;
};

struct crease_march {
    float occluded;
    float points;
    vec3 open;      // directions of the points, weighed by how open they are
    float openness; // sum of these weights
    float rounding; // of depth
};

struct crease_contribution {
    float occlusion;
    float points;
    vec3 open;
    float openness;
};

crease_estimate crease_estimate_begin(crease_receiver receiver) { return crease_estimate(0.0, 0.0); }

crease_march crease_begin_direction(crease_estimate estimate, crease_receiver receiver, vec2 direction) {
    return crease_march(0.0, 0.0, vec3(0.0), 0.0, crease_depth_rounding(-receiver.position.z));
}

// How open the direction to a point is goes into the bent normal: stochastic-depth-ao 7.1, Algorithm 10.
crease_contribution crease_ssao_contribution(crease_tap tap, float occlusion, float points, float openness) {
    vec3 open = tap.offset * (openness * inversesqrt(max(dot(tap.offset, tap.offset), 1e-30)));
    return crease_contribution(occlusion, points, open, openness);
}

crease_contribution crease_weigh(crease_march march, crease_receiver receiver, crease_tap tap, crease_layer layer) {
    // A point close to the tangent plane says nothing. One beside the picture counts as open for the bent normal, as
    // leaving it out would turn the cone to the picture's middle.
    if (dot(tap.offset, receiver.normal) <= crease_point_bias(receiver, crease_ssao_bias))
        return crease_ssao_contribution(tap, 0.0, 0.0, 0.0);
    if (!tap.inside)
        return crease_ssao_contribution(tap, 0.0, 0.0, 1.0);
    float before = crease_layer_before(receiver, layer);
    // Of layers that do not occlude, the tiny negative numbers make one behind the point win over one that is out of
    // range, and either over background, where layers are combined by the greater occlusion.
    if (before - march.rounding < crease_eye_side(receiver) * tap.offset.z) {
        float nothing = layer.position.z > -0.5 * crease_background ? 0.0 : -2e-6;
        return crease_ssao_contribution(tap, nothing, 1.0, 1.0 - nothing);
    }
    float in_range = smoothstep(0.0, 1.0, 2.0 * (1.0 - before / crease_radius));
    float occlusion = in_range > 0.0 ? in_range : -1e-6;
    return crease_ssao_contribution(tap, occlusion, in_range, in_range - occlusion);
}

// What a layer lets through of a point counts as open.
crease_contribution crease_fade(crease_march march, crease_receiver receiver, crease_tap tap,
                                crease_contribution contribution, float opacity) {
    if (!(contribution.occlusion > 0.0))
        return contribution;
    float occlusion = contribution.occlusion * opacity, points = mix(1.0, contribution.points, opacity);
    return crease_ssao_contribution(tap, occlusion, points, points - occlusion);
}

// Where the front one is behind the point, all others are.
bool crease_skip_behind(crease_march march, crease_receiver receiver, crease_tap tap, crease_layer front) {
    return front.position.z - receiver.position.z - march.rounding < tap.offset.z;
}

void crease_add(inout crease_march march, crease_contribution contribution) {
    march.occluded += contribution.occlusion;
    march.points += contribution.points;
    march.open += contribution.open;
    march.openness += contribution.openness;
}

void crease_end_direction(inout crease_estimate estimate, crease_march march) {
    estimate.occluded += march.occluded;
    estimate.points += march.points;
}

crease_open crease_open_direction(crease_march march, crease_receiver receiver, vec2 direction) {
    return crease_open(march.open, march.openness, 0.0);
}

// The normal where no point is open.
vec3 crease_open_mean(crease_open open, crease_receiver receiver) { return open.sum + receiver.normal * 1e-6; }

// The cone that the mean's length stands for.
float crease_open_cone(crease_open open) {
    float mean_length = length(open.sum) / max(open.weight, 1e-6);
    return 1.57079633 * (1.0 - max(2.0 * mean_length - 1.0, 0.0));
}

float crease_estimate_occlusion(crease_estimate estimate) { return estimate.occluded / max(estimate.points, 1.0); }
#ifdef __cplusplus
")glsl"
#endif
