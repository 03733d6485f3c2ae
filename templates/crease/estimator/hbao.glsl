#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// Horizons: stochastic-depth-ao, Algorithm 2, with the threshold of 4.4.
//
// The Z axis of the paper's figure 4.5 is the direction to the eye, and the tangent is taken at the azimuth of the tap
// itself, which its texel moves off the marched direction: so a plane is unoccluded at every slant.

int crease_direction_count();

struct crease_estimate {
    float occlusion; // summed over the directions
    float horizon;   // of this direction: sine of its angle less the sine of the tangent's
    float cos_bias;
    float sin_bias;
    float slope;     // 1 / cosine of the angle between the normal and the direction to the eye
};

struct crease_contribution {
    float occlusion;
    float horizon;
};

crease_estimate crease_estimate_begin(crease_receiver receiver) {
    float facing = max(dot(receiver.normal, receiver.to_eye), 1e-3);
    return crease_estimate(0.0, 0.0, cos(crease_bias), sin(crease_bias), 1.0 / facing);
}

void crease_estimate_turn(inout crease_estimate estimate) { estimate.horizon = 0.0; }

crease_contribution crease_weigh(crease_estimate estimate, crease_receiver receiver, crease_tap tap, vec3 position) {
    vec3 to_tap = position - receiver.position;
    float squared = dot(to_tap, to_tap);
    float height = dot(to_tap, receiver.normal);   // over the tangent plane
    float towards_eye = dot(to_tap, receiver.to_eye);
    float across = squared - towards_eye * towards_eye;
    float tangent_rise = towards_eye - height * estimate.slope;
    float inverse_length = inversesqrt(squared);
    float inverse_tangent = inversesqrt(across + tangent_rise * tangent_rise);
    float sin_tangent = tangent_rise * inverse_tangent;
    float cos_tangent = sqrt(max(across, 0.0)) * inverse_tangent;
    // The tangent's angle plus the bias, at most a right angle.
    float sin_biased = cos_tangent * estimate.cos_bias < sin_tangent * estimate.sin_bias
        ? 1.0
        : sin_tangent * estimate.cos_bias + cos_tangent * estimate.sin_bias;
    float horizon = max(estimate.horizon, sin_biased - sin_tangent);
    float rise = towards_eye * inverse_length - sin_tangent;
    bool counts = rise > horizon && squared < crease_radius * crease_radius &&
                  height * inverse_length > crease_threshold;
    float falloff = 1.0 - squared / (crease_radius * crease_radius);
    return counts ? crease_contribution(falloff * (rise - horizon), rise)
                  : crease_contribution(0.0, estimate.horizon);
}

void crease_estimate_add(inout crease_estimate estimate, crease_contribution contribution) {
    estimate.occlusion += contribution.occlusion;
    estimate.horizon = contribution.horizon;
}

float crease_estimate_occlusion(crease_estimate estimate) {
    return estimate.occlusion / float(crease_direction_count());
}
#ifdef __cplusplus
")glsl"
#endif
