#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// Horizons: stochastic-depth-ao, Algorithm 2, with the threshold of 4.4. The Z axis of the paper's figure 4.5 is the
// direction to the eye.

int crease_direction_count();

struct crease_estimate {
    float occlusion;   // summed over the directions
    float rise;        // of this direction's horizon: sin(horizon) - sin(tangent)
    float sin_tangent; // of this direction
    float cos_tangent;
    float n_dot_v;     // cosine between the normal and the direction to the eye
    vec2 on_disk;      // the normal along the axes of the disk
    vec2 bias;         // cosine and sine of the bias
    float reach;       // 1 / square of the radius
};

struct crease_contribution {
    float occlusion;
    float rise;
};

crease_estimate crease_estimate_begin(crease_receiver receiver) {
    vec2 on_disk = vec2(dot(receiver.normal, receiver.across), dot(receiver.normal, receiver.up));
    return crease_estimate(0.0, 0.0, 0.0, 0.0, dot(receiver.normal, receiver.to_eye), on_disk,
                           vec2(cos(crease_bias), sin(crease_bias)), 1.0 / (crease_radius * crease_radius));
}

void crease_estimate_turn(inout crease_estimate estimate, vec2 direction) {
    float along = dot(estimate.on_disk, direction);
    float inverse = inversesqrt(max(along * along + estimate.n_dot_v * estimate.n_dot_v, 1e-12));
    estimate.sin_tangent = -along * inverse;
    estimate.cos_tangent = estimate.n_dot_v * inverse;
    // The horizon begins at the tangent plus the bias, at most at a right angle.
    float start = estimate.cos_tangent * estimate.bias.x < estimate.sin_tangent * estimate.bias.y
        ? 1.0
        : estimate.sin_tangent * estimate.bias.x + estimate.cos_tangent * estimate.bias.y;
    estimate.rise = start - estimate.sin_tangent;
}

// sin(horizon) - sin(tangent) of a tap, both in the slice of the eye and the tap itself, which its texel moves off the
// marched direction: so a plane is unoccluded at every slant.
float crease_hbao_rise(crease_estimate estimate, crease_receiver receiver, vec3 to_tap, float squared, float height) {
    float towards = dot(to_tap, receiver.to_eye);
    float along = height - estimate.n_dot_v * towards; // of the normal, across the ray to the eye, times the distance
    float across = estimate.n_dot_v * estimate.n_dot_v * (squared - towards * towards);
    float away = sqrt(squared), in_slice = sqrt(along * along + across);
    return (towards * in_slice + along * away) / (away * in_slice);
}

crease_contribution crease_weigh(crease_estimate estimate, crease_receiver receiver, crease_tap tap, vec3 position) {
    vec3 to_tap = position - receiver.position;
    float squared = dot(to_tap, to_tap);
    float height = dot(to_tap, receiver.normal);
    float rise = crease_hbao_rise(estimate, receiver, to_tap, squared, height);
    float falloff = 1.0 - squared * estimate.reach;
    bool counts =
        tap.inside && rise > estimate.rise && falloff > 0.0 && height > crease_threshold * sqrt(squared);
    return counts ? crease_contribution(falloff * (rise - estimate.rise), rise)
                  : crease_contribution(0.0, estimate.rise);
}

void crease_estimate_add(inout crease_estimate estimate, crease_contribution contribution) {
    estimate.occlusion += contribution.occlusion;
    estimate.rise = contribution.rise;
}

float crease_estimate_occlusion(crease_estimate estimate) {
    return estimate.occlusion / float(crease_direction_count());
}
#ifdef __cplusplus
")glsl"
#endif
