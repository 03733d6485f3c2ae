// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
int crease_direction_count();
crease_open crease_turned_normal(crease_receiver receiver, vec2 direction, float cosine, float sine);
#else
__LINE__, R"glsl("
#endif

// Horizons: stochastic-depth-ao, Algorithm 2, with the threshold of 4.4. The Z axis of the paper's figure 4.5 is the
// direction to the eye.
struct crease_estimate {
    float occlusion; // summed over the directions
    float n_dot_v;   // cosine between the normal and the direction to the eye
    vec2 on_disk;    // the normal along the axes of the disk
    vec2 bias;       // cosine and sine of the bias
    float reach;     // 1 / square of the radius
};

// A direction.
struct crease_march {
    float occlusion; // summed over the taps
    float rise;      // of the horizon: sin(horizon) - sin(tangent)
    float sin_tangent;
    float cos_tangent;
    float n_dot_v;
    vec2 bias;
    float reach;
};

struct crease_contribution {
    float occlusion;
    float rise; // of the horizon after it
};

crease_estimate crease_estimate_begin(crease_receiver receiver) {
    vec2 on_disk = vec2(dot(receiver.normal, receiver.tangent), dot(receiver.normal, receiver.bitangent));
    return crease_estimate(0.0, dot(receiver.normal, receiver.to_eye), on_disk,
                           vec2(cos(crease_hbao_bias), sin(crease_hbao_bias)), 1.0 / (crease_radius * crease_radius));
}

crease_march crease_begin_direction(crease_estimate estimate, crease_receiver receiver, vec2 direction) {
    float along = dot(estimate.on_disk, direction);
    float inverse = inversesqrt(max(along * along + estimate.n_dot_v * estimate.n_dot_v, 1e-12));
    float sin_tangent = -along * inverse, cos_tangent = estimate.n_dot_v * inverse;
    // The horizon begins at the tangent plus the bias, at most at a right angle.
    float start = cos_tangent * estimate.bias.x < sin_tangent * estimate.bias.y
        ? 1.0
        : sin_tangent * estimate.bias.x + cos_tangent * estimate.bias.y;
    return crease_march(0.0, start - sin_tangent, sin_tangent, cos_tangent, estimate.n_dot_v, estimate.bias,
                        estimate.reach);
}

// sin(horizon) - sin(tangent) of a layer, both in the plane of the eye and the layer itself: that is not quite the
// plane of the march, as a tap lies at the centre of its texel, and so a plane is unoccluded at every slant.
float crease_hbao_rise(crease_march march, crease_receiver receiver, vec3 to_layer, float squared, float height) {
    float towards = dot(to_layer, receiver.to_eye);
    float along = height - march.n_dot_v * towards; // of the normal, across the ray to the eye, times the distance
    float across = march.n_dot_v * march.n_dot_v * (squared - towards * towards);
    float away = sqrt(squared), in_slice = sqrt(along * along + across);
    return (towards * in_slice + along * away) / (away * in_slice);
}

crease_contribution crease_weigh(crease_march march, crease_receiver receiver, crease_tap tap, crease_layer layer) {
    vec3 to_layer = layer.position - receiver.position;
    float squared = dot(to_layer, to_layer);
    float height = dot(to_layer, receiver.normal);
    float rise = crease_hbao_rise(march, receiver, to_layer, squared, height);
    float falloff = 1.0 - squared * march.reach;
    bool counts =
        tap.inside && rise > march.rise && falloff > 0.0 && height > crease_hbao_threshold * sqrt(squared);
    return crease_contribution(counts ? falloff * (rise - march.rise) : 0.0, counts ? rise : march.rise);
}

// A layer with an opacity raises the horizon by that share of its rise over the horizon's start, whichever taps came before.
crease_contribution crease_fade(crease_march march, crease_receiver receiver, crease_tap tap,
                                crease_contribution contribution, float opacity) {
    float start = march.cos_tangent * march.bias.x < march.sin_tangent * march.bias.y
        ? 1.0
        : march.sin_tangent * march.bias.x + march.cos_tangent * march.bias.y;
    float own = mix(start - march.sin_tangent, contribution.rise, opacity);
    bool raises = contribution.rise > march.rise && own > march.rise;
    float share = raises ? (own - march.rise) / (contribution.rise - march.rise) : 0.0;
    return crease_contribution(share * contribution.occlusion, mix(march.rise, contribution.rise, share));
}

// Of all layers of a texel the front one rises the most; if that is below the horizon, so are the others.
bool crease_skip_behind(crease_march march, crease_receiver receiver, crease_tap tap, crease_layer front) {
    vec3 to_layer = front.position - receiver.position;
    float rise = crease_hbao_rise(march, receiver, to_layer, dot(to_layer, to_layer), dot(to_layer, receiver.normal));
    return !(rise > march.rise);
}

void crease_add(inout crease_march march, crease_contribution contribution) {
    march.occlusion += contribution.occlusion;
    march.rise = contribution.rise;
}

// Layers behind count from the horizon of all front ones.
void crease_add_behind(inout crease_march march, crease_contribution front, crease_contribution behind) {
    march.occlusion += behind.occlusion;
    march.rise = max(march.rise, behind.rise);
}

void crease_end_direction(inout crease_estimate estimate, crease_march march) { estimate.occlusion += march.occlusion; }

// The normal, turned away from the horizon by the horizon's angle over the tangent: stochastic-depth-ao 7.1, Algorithm
// 11.
crease_open crease_open_direction(crease_march march, crease_receiver receiver, vec2 direction) {
    vec2 start = vec2(march.cos_tangent * march.bias.x - march.sin_tangent * march.bias.y,
                      march.sin_tangent * march.bias.x + march.cos_tangent * march.bias.y);
    float sin_horizon = min(march.sin_tangent + march.rise, 1.0);
    float cos_horizon = sqrt(1.0 - sin_horizon * sin_horizon);
    // Of the angle between the horizon and where it began.
    float cosine = cos_horizon * start.x + sin_horizon * start.y;
    float sine = max(sin_horizon * start.x - cos_horizon * start.y, 0.0);
    return crease_turned_normal(receiver, direction, cosine, sine);
}

float crease_estimate_occlusion(crease_estimate estimate) {
    return estimate.occlusion / float(crease_direction_count());
}
#ifdef __cplusplus
")glsl"
#endif
