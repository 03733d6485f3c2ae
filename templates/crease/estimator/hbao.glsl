#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// Horizons: stochastic-depth-ao, Algorithm 2, with the threshold of 4.4.
//
// The Z axis of the paper's figure 4.5 is the direction to the eye. The angle of a tap is the tangent's plus its angle
// over the tangent plane, which is measured at the tap's own azimuth, as its texel moves it off the marched direction:
// so a plane is unoccluded at every slant.

int crease_direction_count();

struct crease_estimate {
    float occlusion;   // summed over the directions
    float horizon;     // of this direction: sine of its angle
    float sin_tangent; // of this direction
    float cos_tangent;
    float steepness;   // 1 / length of the normal's part in the plane of this direction and the eye
    vec2 lean;         // slope of the tangent plane along the axes of the disk
    float averted;     // 1 / cosine of the angle between the normal and the direction to the eye
    vec2 bias;         // cosine and sine of the bias
    float reach;       // 1 / square of the radius
};

struct crease_contribution {
    float occlusion;
    float horizon;
};

crease_estimate crease_estimate_begin(crease_receiver receiver) {
    float averted = 1.0 / max(dot(receiver.normal, receiver.to_eye), 1e-3);
    vec2 lean = -averted * vec2(dot(receiver.normal, receiver.across), dot(receiver.normal, receiver.up));
    return crease_estimate(0.0, 0.0, 0.0, 0.0, 0.0, lean, averted, vec2(cos(crease_bias), sin(crease_bias)),
                           1.0 / (crease_radius * crease_radius));
}

void crease_estimate_turn(inout crease_estimate estimate, vec2 direction) {
    float slope = dot(estimate.lean, direction);
    estimate.cos_tangent = inversesqrt(1.0 + slope * slope);
    estimate.sin_tangent = slope * estimate.cos_tangent;
    estimate.steepness = estimate.cos_tangent * estimate.averted;
    // The tangent's angle plus the bias, at most a right angle.
    estimate.horizon = estimate.cos_tangent * estimate.bias.x < estimate.sin_tangent * estimate.bias.y
        ? 1.0
        : estimate.sin_tangent * estimate.bias.x + estimate.cos_tangent * estimate.bias.y;
}

// Sine of the angle of a tap, of the square of its distance and its height over the tangent plane.
float crease_hbao_sine(crease_estimate estimate, float squared, float height) {
    // The tap's parts across and along the tangent plane, turned by the tangent's angle.
    float away = sqrt(squared);
    float across = height * estimate.steepness;
    across = across < away ? across : away; // min() is more work for some drivers, which see to NaN in it
    float along = sqrt(max(squared - across * across, 0.0));
    return (estimate.cos_tangent * across + estimate.sin_tangent * along) / away;
}

crease_contribution crease_weigh(crease_estimate estimate, crease_receiver receiver, crease_tap tap, vec3 position) {
    vec3 to_tap = position - receiver.position;
    float squared = dot(to_tap, to_tap);
    float height = dot(to_tap, receiver.normal);
    float sine = crease_hbao_sine(estimate, squared, height);
    float falloff = 1.0 - squared * estimate.reach;
    bool counts =
        tap.inside && sine > estimate.horizon && falloff > 0.0 && height > crease_threshold * sqrt(squared);
    return counts ? crease_contribution(falloff * (sine - estimate.horizon), sine)
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
