// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
float crease_slice_weight(float share);
float crease_half_slice_measure(vec2 normal, float cosine);
crease_half_slice crease_half_slice_along(crease_receiver receiver, vec2 direction);
vec2 crease_half_slice_normal(crease_half_slice slice, crease_receiver receiver, vec3 to_point);
crease_half_slice crease_half_slice_of(vec2 normal);
#else
__LINE__, R"glsl("
#endif

// Ground-truth ambient occlusion: Jimenez et al. 2016. Each half of a slice is integrated by itself, so directions need
// no opposites; occlusion is the share of the cosine lobe over the tangent plane that the horizon hides.
struct crease_estimate {
    float hidden; // summed over the directions, by their weights
    float whole;  // sum of the weights
};

// A direction.
struct crease_march {
    crease_half_slice slice;
    float rise; // of the horizon over the tangent plane: the difference of their cosines to the way to the eye
};

struct crease_contribution {
    float occlusion; // the rise
};

crease_estimate crease_estimate_begin(crease_receiver receiver) { return crease_estimate(0.0, 0.0); }

crease_march crease_begin_direction(crease_estimate estimate, crease_receiver receiver, vec2 direction) {
    return crease_march(crease_half_slice_along(receiver, direction), 0.0);
}

// Of a layer in the half slice in which it lies.
float crease_gtao_rise(crease_march march, crease_receiver receiver, vec3 to_layer) {
    vec2 normal = crease_half_slice_normal(march.slice, receiver, to_layer);
    float tangent = clamp(-normal.y * inversesqrt(max(dot(normal, normal), 1e-12)), -1.0, 1.0);
    return dot(to_layer, receiver.to_eye) * inversesqrt(max(dot(to_layer, to_layer), 1e-30)) - tangent;
}

// A layer far away lowers its horizon to the tangent plane, and one that stands before the receiver is farther by that.
crease_contribution crease_weigh(crease_march march, crease_receiver receiver, crease_tap tap, crease_layer layer) {
    vec3 to_layer = layer.position - receiver.position;
    vec3 stretched = vec3(to_layer.xy, to_layer.z * (1.0 + crease_gtao_thin_occluders));
    float radii = length(stretched) / max(crease_radius, 1e-20);
    float nearness = clamp((1.0 - radii) / max(crease_gtao_falloff, 1e-6), 0.0, 1.0);
    return crease_contribution(tap.inside ? nearness * crease_gtao_rise(march, receiver, to_layer) : 0.0);
}

// What a horizon hides of the lobe around the way to the eye goes with the square of its cosine.
crease_contribution crease_fade(crease_march march, crease_receiver receiver, crease_tap tap,
                                crease_contribution contribution, float opacity) {
    return crease_contribution(contribution.occlusion * sqrt(opacity));
}

// Of all layers of a texel the front one rises the most; if that is below the horizon, so are the others.
bool crease_skip_behind(crease_march march, crease_receiver receiver, crease_tap tap, crease_layer front) {
    return !(crease_gtao_rise(march, receiver, front.position - receiver.position) > march.rise);
}

void crease_add(inout crease_march march, crease_contribution contribution) {
    march.rise = max(march.rise, contribution.occlusion);
}

void crease_add_behind(inout crease_march march, crease_contribution front, crease_contribution behind) {
    crease_add(march, behind);
}

float crease_gtao_horizon(crease_march march) { return min(march.slice.tangent + march.rise, 1.0); }

void crease_end_direction(inout crease_estimate estimate, crease_march march) {
    float hidden = march.slice.share - crease_half_slice_measure(march.slice.normal, crease_gtao_horizon(march));
    float weight = crease_slice_weight(march.slice.share);
    estimate.hidden += weight * hidden / max(march.slice.share, 1e-6);
    estimate.whole += weight;
}

// The integral of the directions up to the angle of this cosine, by the measure: along the direction, and to the eye.
vec2 crease_gtao_sum(vec2 normal, float cosine) {
    float cubed = cosine * cosine * cosine, sine = sqrt(1.0 - cosine * cosine);
    float sine_cubed = sine * sine * sine;
    return vec2(normal.x * sine_cubed + normal.y * (2.0 - 3.0 * cosine + cubed),
                normal.x * (1.0 - cubed) + normal.y * sine_cubed) / 3.0;
}

// What the horizon takes of the mean direction, and the angle by which it rises. One and a half times the mean of all
// half slices is the normal.
crease_open crease_open_direction(crease_march march, crease_receiver receiver, vec2 direction) {
    float horizon = crease_gtao_horizon(march), weight = crease_slice_weight(march.slice.share);
    vec2 whole = crease_gtao_sum(march.slice.normal, march.slice.tangent);
    vec2 moved = crease_gtao_sum(march.slice.normal, horizon) - whole;
    moved *= 1.5 * weight / max(march.slice.share, 1e-6);
    float turned = acos(march.slice.tangent) - acos(horizon);
    return crease_open(vec3(direction * moved.x, moved.y), weight, weight * turned);
}

float crease_estimate_occlusion(crease_estimate estimate) { return estimate.hidden / max(estimate.whole, 1e-6); }
#ifdef __cplusplus
")glsl"
#endif
