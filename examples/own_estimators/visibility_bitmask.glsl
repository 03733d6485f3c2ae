// SPDX-License-Identifier: MIT
#ifndef __cplusplus
vec3 crease_to_eye(vec3 position);
#else
__LINE__, R"glsl("
#endif

// Visibility bitmask: Therrien et al. 2023. A direction marches through half a slice, in which angles count from the way to
// the eye. What is over the tangent plane is divided into 32 sectors of equal cosine-weighted measure, so that each counts
// the same; a layer hides those from its front to its back.
struct crease_estimate {
    float hidden;  // summed over the directions: of each the measure of its hidden sectors
    float whole;   // and that of all
    float n_dot_v; // cosine between the normal and the way to the eye
    vec2 on_disk;  // the normal along the axes of the disk
};

// Half a slice.
struct crease_visibility_bitmask_slice {
    vec2 normal;   // along the ways to the eye and of the half slice
    float tangent; // cosine between the tangent plane and the way to the eye
    float whole;   // measure of what is over the tangent plane
};

// A direction.
struct crease_march {
    crease_visibility_bitmask_slice slice;
    uint hidden; // a bit for each sector, the lowest at the eye
};

struct crease_contribution {
    uint hidden;
};

// Of the angles up to that of this cosine.
float crease_visibility_bitmask_measure(vec2 normal, float cosine) {
    float sine = sqrt(1.0 - cosine * cosine);
    return 0.5 * (normal.x * sine * sine + normal.y * (acos(cosine) - sine * cosine));
}

crease_visibility_bitmask_slice crease_visibility_bitmask_slice_of(vec2 normal) {
    float tangent = clamp(-normal.y * inversesqrt(max(dot(normal, normal), 1e-12)), -1.0, 1.0); // in spite of rounding
    return crease_visibility_bitmask_slice(normal, tangent, crease_visibility_bitmask_measure(normal, tangent));
}

// The half slice in which a point lies, which its texel moves off the marched direction: so a plane is unoccluded at every
// slant.
crease_visibility_bitmask_slice crease_visibility_bitmask_slice_through(crease_march march, crease_receiver receiver,
                                                                        vec3 to_point) {
    float squared = dot(to_point, to_point), towards = dot(to_point, receiver.to_eye);
    float across = sqrt(max(squared - towards * towards, 1e-12 * squared));
    float facing = march.slice.normal.x;
    return crease_visibility_bitmask_slice_of(
        vec2(facing, (dot(to_point, receiver.normal) - facing * towards) / across));
}

// The sectors from that of a point down to the tangent plane.
uint crease_visibility_bitmask_from(crease_visibility_bitmask_slice slice, crease_receiver receiver, vec3 to_point) {
    float cosine = dot(to_point, receiver.to_eye) * inversesqrt(dot(to_point, to_point));
    float measure = crease_visibility_bitmask_measure(slice.normal, clamp(cosine, slice.tangent, 1.0));
    int sector = int(32.0 * measure / max(slice.whole, 1e-6) + 0.5);
    return sector < 32 ? ~0u << sector : 0u;
}

crease_estimate crease_estimate_begin(crease_receiver receiver) {
    vec2 on_disk = vec2(dot(receiver.normal, receiver.tangent), dot(receiver.normal, receiver.bitangent));
    return crease_estimate(0.0, 0.0, max(dot(receiver.normal, receiver.to_eye), 0.0), on_disk);
}

crease_march crease_begin_direction(crease_estimate estimate, crease_receiver receiver, vec2 direction) {
    vec2 normal = vec2(estimate.n_dot_v, dot(estimate.on_disk, direction));
    return crease_march(crease_visibility_bitmask_slice_of(normal), 0u);
}

// What of a layer is in the sphere of the radius.
crease_contribution crease_weigh(crease_march march, crease_receiver receiver, crease_tap tap, crease_layer layer) {
    vec3 to_layer = layer.position - receiver.position, back = -crease_to_eye(layer.position);
    float middle = -dot(to_layer, back); // of the sphere, from the front back
    float squared = crease_radius * crease_radius - dot(to_layer, to_layer) + middle * middle;
    float inside = sqrt(max(squared, 0.0));
    float first = max(middle - inside, 0.0);
    float last = min(middle + inside, crease_visibility_bitmask_thickness * crease_radius);
    if (!tap.inside || !(first < last))
        return crease_contribution(0u);
    vec3 to_first = to_layer + first * back, to_last = to_layer + last * back;
    crease_visibility_bitmask_slice slice = crease_visibility_bitmask_slice_through(march, receiver, to_first);
    return crease_contribution(crease_visibility_bitmask_from(slice, receiver, to_first) &
                               ~crease_visibility_bitmask_from(slice, receiver, to_last));
}

// Layers of a tap hide what any of them hides.
crease_contribution crease_combine(crease_contribution a, crease_contribution b) {
    return crease_contribution(a.hidden | b.hidden);
}

// Going away from the eye leads down to the tangent plane.
bool crease_skip_behind(crease_march march, crease_receiver receiver, crease_tap tap, crease_layer front) {
    vec3 to_front = front.position - receiver.position;
    crease_visibility_bitmask_slice slice = crease_visibility_bitmask_slice_through(march, receiver, to_front);
    return (crease_visibility_bitmask_from(slice, receiver, to_front) & ~march.hidden) == 0u;
}

void crease_add(inout crease_march march, crease_contribution contribution) { march.hidden |= contribution.hidden; }

void crease_add_behind(inout crease_march march, crease_contribution front, crease_contribution behind) {
    crease_add(march, behind);
}

float crease_visibility_bitmask_share(uint sectors) { return float(bitCount(sectors)) / 32.0; }

void crease_end_direction(inout crease_estimate estimate, crease_march march) {
    estimate.hidden += march.slice.whole * crease_visibility_bitmask_share(march.hidden);
    estimate.whole += march.slice.whole;
}

// The angle up to which this share of the measure is: exact where the normal points to the eye.
float crease_visibility_bitmask_angle(crease_visibility_bitmask_slice slice, float share) {
    return acos(slice.tangent) * asin(sqrt(share)) / 1.57079633;
}

// What hidden sectors, four by four, take of the mean open direction. Three times its integral over all half slices has the
// normal as its mean.
crease_open crease_open_direction(crease_march march, crease_receiver receiver, vec2 direction) {
    vec2 moved = vec2(0.0); // along the direction, and to the eye
    for (int i = 0; i < 8; ++i) {
        float angle = crease_visibility_bitmask_angle(march.slice, (float(i) + 0.5) / 8.0);
        float hidden = crease_visibility_bitmask_share(march.hidden & (15u << (4 * i)));
        moved -= 3.0 * march.slice.whole * hidden * vec2(sin(angle), cos(angle));
    }
    float open = 1.0 - crease_visibility_bitmask_share(march.hidden);
    return crease_open(vec3(direction * moved.x, moved.y), 1.0,
                       acos(march.slice.tangent) - crease_visibility_bitmask_angle(march.slice, open));
}

float crease_estimate_occlusion(crease_estimate estimate) { return estimate.hidden / max(estimate.whole, 1e-6); }
#ifdef __cplusplus
")glsl"
#endif
