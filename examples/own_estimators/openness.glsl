// SPDX-License-Identifier: MIT
#ifndef __cplusplus
int crease_direction_count();
crease_open crease_turned_normal(crease_receiver receiver, vec2 direction, float cosine, float sine);
#else
__LINE__, R"glsl("
#endif

// Openness: Yokoyama et al. 2002, who map terrain by it. Of each direction the angle over the tangent plane of what rises
// the highest within the radius, as a share of a right angle.
struct crease_estimate {
    float closed; // summed over the directions
};

// A direction.
struct crease_march {
    float sine; // of the highest angle
};

struct crease_contribution {
    float occlusion; // the sine of an angle
};

crease_estimate crease_estimate_begin(crease_receiver receiver) { return crease_estimate(0.0); }

crease_march crease_begin_direction(crease_estimate estimate, crease_receiver receiver, vec2 direction) {
    return crease_march(0.0);
}

// What is farther away than `crease_openness_reach` radii rises less and less, up to one radius.
crease_contribution crease_weigh(crease_march march, crease_receiver receiver, crease_tap tap, crease_layer layer) {
    vec3 to_layer = layer.position - receiver.position;
    float distance = max(length(to_layer), 1e-20), radii = distance / max(crease_radius, 1e-20);
    float nearness = clamp((1.0 - radii) / max(1.0 - crease_openness_reach, 1e-6), 0.0, 1.0);
    float sine = dot(to_layer, receiver.normal) / distance - crease_openness_bias;
    return crease_contribution(tap.inside ? nearness * max(sine, 0.0) : 0.0);
}

void crease_add(inout crease_march march, crease_contribution contribution) {
    march.sine = max(march.sine, contribution.occlusion);
}

void crease_add_behind(inout crease_march march, crease_contribution front, crease_contribution behind) {
    crease_add(march, behind);
}

void crease_end_direction(inout crease_estimate estimate, crease_march march) {
    estimate.closed += asin(min(march.sine, 1.0)) / 1.57079633;
}

crease_open crease_open_direction(crease_march march, crease_receiver receiver, vec2 direction) {
    float sine = min(march.sine, 1.0);
    return crease_turned_normal(receiver, direction, sqrt(1.0 - sine * sine), sine);
}

float crease_estimate_occlusion(crease_estimate estimate) { return estimate.closed / float(crease_direction_count()); }
#ifdef __cplusplus
")glsl"
#endif
