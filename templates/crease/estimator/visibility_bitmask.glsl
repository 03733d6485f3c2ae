// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
vec3 crease_to_eye(vec3 position);
float crease_eye_side(crease_receiver receiver);
float crease_slice_weight(float share);
int crease_bit_count(uint bits);
float crease_half_slice_measure(vec2 normal, float cosine);
crease_half_slice crease_half_slice_along(crease_receiver receiver, vec2 direction);
vec2 crease_half_slice_normal(crease_half_slice slice, crease_receiver receiver, vec3 to_point);
crease_half_slice crease_half_slice_of(vec2 normal);
uint crease_sectors_of_opacity(float opacity);
#else
__LINE__, R"glsl("
#endif

// Visibility bitmask: Therrien et al. 2023. The angles of a half slice, from the way to the eye down to the tangent
// plane, are divided into 32 even sectors, each of which counts the same; a layer hides those from front to back.
struct crease_estimate {
    float hidden; // summed over the directions, by their weights: the shares of hidden sectors
    float whole;  // sum of the weights
};

// A direction.
struct crease_march {
    crease_half_slice slice;
    uint hidden; // a bit for each sector, the lowest at the eye
};

struct crease_contribution {
    uint hidden;
};

crease_estimate crease_estimate_begin(crease_receiver receiver) { return crease_estimate(0.0, 0.0); }

crease_march crease_begin_direction(crease_estimate estimate, crease_receiver receiver, vec2 direction) {
    return crease_march(crease_half_slice_along(receiver, direction), 0u);
}

// The sectors from a point down to the tangent plane in the half slice in which it lies.
uint crease_visibility_bitmask_from(crease_march march, crease_receiver receiver, vec3 to_point) {
    vec2 normal = crease_half_slice_normal(march.slice, receiver, to_point);
    float tangent = clamp(-normal.y * inversesqrt(max(dot(normal, normal), 1e-12)), -1.0, 1.0);
    float cosine = dot(to_point, receiver.to_eye) * inversesqrt(max(dot(to_point, to_point), 1e-30));
    int sector = int(32.0 * acos(clamp(cosine, tangent, 1.0)) / max(acos(tangent), 1e-6) + 0.5);
    return sector < 32 ? ~0u << uint(sector) : 0u;
}

// What of a layer is in the sphere of the radius.
crease_contribution crease_weigh(crease_march march, crease_receiver receiver, crease_tap tap, crease_layer layer) {
    vec3 to_layer = layer.position - receiver.position;
    vec3 back = -crease_eye_side(receiver) * crease_to_eye(layer.position);
    float middle = -dot(to_layer, back); // of the sphere, from the front back
    float apart = dot(to_layer, to_layer);
    float inside = sqrt(max(crease_radius * crease_radius - apart + middle * middle, 0.0));
    float first = max(middle - inside, 0.0);
    float last = min(middle + inside, crease_visibility_bitmask_thickness * crease_radius);
    if (!tap.inside || !(first < last))
        return crease_contribution(0u);
    return crease_contribution(crease_visibility_bitmask_from(march, receiver, to_layer + first * back) &
                               ~crease_visibility_bitmask_from(march, receiver, to_layer + last * back));
}

crease_contribution crease_fade(crease_march march, crease_receiver receiver, crease_tap tap,
                                crease_contribution contribution, float opacity) {
    return crease_contribution(contribution.hidden & crease_sectors_of_opacity(opacity));
}

// Layers of a tap hide what any of them hides.
crease_contribution crease_combine(crease_contribution a, crease_contribution b) {
    return crease_contribution(a.hidden | b.hidden);
}

// Going away from the eye leads down to the tangent plane.
bool crease_skip_behind(crease_march march, crease_receiver receiver, crease_tap tap, crease_layer front) {
    vec3 to_front = front.position - receiver.position;
    return (crease_visibility_bitmask_from(march, receiver, to_front) & ~march.hidden) == 0u;
}

void crease_add(inout crease_march march, crease_contribution contribution) { march.hidden |= contribution.hidden; }

void crease_add_behind(inout crease_march march, crease_contribution front, crease_contribution behind) {
    crease_add(march, behind);
}

void crease_end_direction(inout crease_estimate estimate, crease_march march) {
    float weight = crease_slice_weight(march.slice.share);
    estimate.hidden += weight * float(crease_bit_count(march.hidden)) / 32.0;
    estimate.whole += weight;
}

// What hidden sectors, four by four, take of the mean direction. One and a half times the mean of all half slices is
// the normal.
crease_open crease_open_direction(crease_march march, crease_receiver receiver, vec2 direction) {
    float weight = crease_slice_weight(march.slice.share), width = acos(march.slice.tangent) / 8.0;
    vec2 moved = vec2(0.0); // along the direction, and to the eye
    float before = 0.0;     // measure up to the sectors
    for (int i = 0; i < 8; ++i) {
        float angle = width * (float(i) + 0.5);
        float after = crease_half_slice_measure(march.slice.normal, cos(width * float(i + 1)));
        float hidden = float(crease_bit_count(march.hidden & (15u << uint(4 * i)))) / 4.0;
        moved -= vec2(sin(angle), cos(angle)) * (hidden * (after - before));
        before = after;
    }
    moved *= 1.5 * weight / max(march.slice.share, 1e-6);
    float turned = 8.0 * width * float(crease_bit_count(march.hidden)) / 32.0;
    return crease_open(vec3(direction * moved.x, moved.y), weight, weight * turned);
}

float crease_estimate_occlusion(crease_estimate estimate) { return estimate.hidden / max(estimate.whole, 1e-6); }
#ifdef __cplusplus
")glsl"
#endif
