// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
vec3 crease_view_position(vec2 texel, float depth);
float crease_depth_rounding(float depth);
float crease_slice_weight(float share);
float crease_layer_thickness(crease_layer layer);
int crease_step_count();
int crease_bit_count(uint bits);
uint crease_sectors_of_opacity(float opacity);
#else
__LINE__, R"glsl("
#endif

// A bitmask of the cosine lobe: Therrien et al. 2023, with sectors of equal cosine-weighted measure and without acos.
// Angles in the half slice of a direction count from the normal projected into it, towards the direction: that of the
// eye is -g, that of the tangent plane a right angle. With the normal's parts a along the way to the eye and b along
// the direction, the measure up to the angle of sine s is, but for a constant,
//     (a s^2 + b B(s)) / 2, where B(s) = asin s + s sqrt(1 - s^2), which is about s (2 - (2 - pi / 2) s^2).
const int crease_cosine_bitmask_sectors = 31; // so that 1 << 31 is above the last
const float crease_cosine_bitmask_cubic = 0.42920367;

// What is between the layer of a tap and another behind it. Heights over the tangent plane and distances along it are
// in the slice, times cos g.
struct crease_cosine_bitmask_slab {
    float height, along;         // of the layer
    float ray_height, ray_along; // of the way on from it by a depth of 1
    float depth;                 // of the layer
    float gap;                   // of the taps, as a share of the distance
    float thickness, thin;       // depth; of the slab, and if it is isolated
};

struct crease_estimate {
    float hidden; // summed over the directions, by their weights: sectors
    float whole;  // sum of the weights
};

// A direction.
struct crease_march {
    vec3 height, along;                   // rows that give heights and distances of ways
    float bias;                           // taken off heights, as rounding makes planes rough
    float reach;                          // 1 / (radius cos g)
    vec2 constant, linear, square, cubic; // of the sector at a sine, from the tangent plane up; all alike
    float weight;
    vec2 towards;                         // cosine and sine of g
    uint hidden;                          // a bit for each sector, the lowest at the tangent plane
    float occlusion;                      // of the hidden sectors, by how near they are hidden
    int taps;
    crease_cosine_bitmask_slab last;      // of the tap before, which waits for the next
    float before_last;                    // depth
};

struct crease_contribution {
    crease_cosine_bitmask_slab slab;           // the nearest of the tap
    uint own, behind;                          // sectors that it hides, and those behind it: where a tap has several
    float own_nearness, behind_nearness;
};

crease_estimate crease_estimate_begin(crease_receiver receiver) { return crease_estimate(0.0, 0.0); }

crease_march crease_begin_direction(crease_estimate estimate, crease_receiver receiver, vec2 direction) {
    vec3 azimuth = receiver.tangent * direction.x + receiver.bitangent * direction.y;
    vec2 normal = vec2(max(dot(receiver.normal, receiver.to_eye), 0.0), dot(receiver.normal, azimuth));
    float inverse = inversesqrt(max(dot(normal, normal), 1e-12));
    vec2 towards = normal * inverse;
    float sine_part = 1.57079633 + towards.y * (2.0 - crease_cosine_bitmask_cubic * towards.y * towards.y);
    // The approximation falls below 0 where the normal leans far away.
    float whole = max(normal.x * towards.x * towards.x + normal.y * sine_part, 0.02);
    vec2 each = normal * (float(crease_cosine_bitmask_sectors) / whole);
    crease_march march;
    march.height = receiver.normal * (towards.x * inverse);
    march.along = azimuth - receiver.normal * (towards.y * inverse);
    float depth = -receiver.position.z;
    march.bias = (1e-5 * depth + crease_depth_rounding(depth)) * (towards.x * inverse);
    march.reach = 1.0 / (max(crease_radius, 1e-20) * max(towards.x, 1e-6));
    march.constant = vec2(each.x + each.y * 1.57079633 + 0.5); // rounds
    march.linear = vec2(-2.0 * each.y);
    march.square = vec2(-each.x);
    march.cubic = vec2(crease_cosine_bitmask_cubic * each.y);
    march.weight = crease_slice_weight(0.5 * whole);
    march.towards = towards;
    march.hidden = 0u;
    march.occlusion = 0.0;
    march.taps = 0;
    march.last = crease_cosine_bitmask_slab(-1.0, 0.0, 0.0, 0.0, -receiver.position.z, 0.0, 0.0, 0.0);
    march.before_last = 0.0;
    return march;
}

float crease_cosine_bitmask_sector(crease_march march, float sine) {
    float sector =
        march.constant.x + sine * (march.linear.x + sine * (march.square.x + sine * march.cubic.x));
    return clamp(sector, 0.0, 31.0);
}

// The edge of a layer lies somewhere between its tap and the one before.
float crease_cosine_bitmask_nearer(float gap) { return max(1.0 - 0.3 * gap, 0.4); }

// The bits of the sectors where a slab of this thickness begins and ends, and how near it is: 1 / the distance of its
// nearer end, over cos g.
uvec2 crease_cosine_bitmask_ends_of(crease_march march, crease_cosine_bitmask_slab slab, float thickness,
                                    out float nearest) {
    vec2 height = vec2(slab.height, slab.ray_height * thickness + slab.height);
    vec2 along = vec2(slab.along * crease_cosine_bitmask_nearer(slab.gap), slab.ray_along * thickness + slab.along);
    vec2 inverse = inversesqrt(height * height + along * along);
    nearest = max(inverse.x, inverse.y);
    vec2 sine = along * inverse;
    vec2 sector = march.constant + sine * (march.linear + sine * (march.square + sine * march.cubic));
    sector = mix(vec2(0.0), clamp(sector, 0.0, 31.0), greaterThan(height, vec2(0.0)));
    return uvec2(1u) << uvec2(sector);
}

// The sectors that it hides.
uint crease_cosine_bitmask_sectors_of(crease_march march, crease_cosine_bitmask_slab slab, float thickness,
                                      out float nearest) {
    uvec2 bit = crease_cosine_bitmask_ends_of(march, slab, thickness, nearest);
    uint hidden = bit.x - min(bit.x, bit.y);
    return nearest > march.reach ? hidden : 0u; // a select; a branch costs more
}

void crease_cosine_bitmask_hide(inout crease_march march, uint hidden, float nearness) {
    if (crease_cosine_bitmask_linear != 0)
        march.occlusion += float(crease_bit_count(hidden & ~march.hidden)) * nearness;
    march.hidden |= hidden;
}

void crease_cosine_bitmask_hide_last(inout crease_march march, float thickness) {
    float nearest;
    uint hidden = crease_cosine_bitmask_sectors_of(march, march.last, thickness, nearest);
    crease_cosine_bitmask_hide(march, hidden, 1.0 - march.reach / nearest);
}

// What is known to be thinner than the taps are far apart would fall between them.
float crease_cosine_bitmask_thickness_of(crease_layer layer) {
    float known = crease_layer_thickness(layer);
    float least = max(0.25 - 0.0125 * float(crease_step_count()), 0.1);
    return known < 0.0 ? crease_cosine_bitmask_thickness * crease_radius : max(known, least * crease_radius);
}

crease_contribution crease_weigh(crease_march march, crease_receiver receiver, crease_tap tap, crease_layer layer) {
    vec3 eye = crease_view_position(tap.texel, 0.0), ray = crease_view_position(tap.texel, 1.0) - eye;
    vec3 start = eye - receiver.position;
    crease_cosine_bitmask_slab slab;
    slab.depth = -layer.position.z;
    slab.ray_height = dot(march.height, ray);
    slab.ray_along = dot(march.along, ray);
    slab.height = slab.ray_height * slab.depth + (dot(march.height, start) - march.bias);
    slab.height = tap.inside ? slab.height : -1.0;
    slab.along = slab.ray_along * slab.depth + dot(march.along, start);
    slab.gap = tap.gap;
    slab.thickness = crease_cosine_bitmask_thickness_of(layer);
    float thin = min(tap.gap * tap.distance + 0.03, crease_cosine_bitmask_thickness) * crease_radius;
    slab.thin = crease_layer_thickness(layer) < 0.0 ? thin : slab.thickness;
    crease_contribution contribution = crease_contribution(slab, 0u, 0u, 0.0, 0.0);
    if (crease_most_layers > 1) {
        float nearest;
        contribution.own = crease_cosine_bitmask_sectors_of(march, slab, slab.thickness, nearest);
        contribution.own_nearness = 1.0 - march.reach / nearest;
    }
    return contribution;
}

// Where a tap has one layer, the sectors that it may hide.
crease_contribution crease_fade(crease_march march, crease_receiver receiver, crease_tap tap,
                                crease_contribution contribution, float opacity) {
    contribution.own = (crease_most_layers > 1 ? contribution.own : ~0u) & crease_sectors_of_opacity(opacity);
    return contribution;
}

// Layers of a tap hide what any of them hides.
crease_contribution crease_combine(crease_contribution a, crease_contribution b) {
    crease_contribution near = a, far = b;
    if (b.slab.depth < a.slab.depth) {
        near = b;
        far = a;
    }
    uint added = (far.own | far.behind) & ~near.behind;
    float before = float(crease_bit_count(near.behind)), more = float(crease_bit_count(added));
    near.behind_nearness = (before * near.behind_nearness + more * max(far.own_nearness, far.behind_nearness)) /
        max(before + more, 1.0);
    near.behind |= added;
    return near;
}

// The way on from a layer leads down to the tangent plane.
bool crease_skip_behind(crease_march march, crease_receiver receiver, crease_tap tap, crease_layer front) {
    vec3 to_front = front.position - receiver.position;
    float height = dot(march.height, to_front) - march.bias;
    float along = dot(march.along, to_front) * crease_cosine_bitmask_nearer(tap.gap);
    float sector = crease_cosine_bitmask_sector(march, along * inversesqrt(height * height + along * along));
    uint below = height > 0.0 ? (1u << uint(sector)) - 1u : 0u;
    return (below & ~march.hidden) == 0u;
}

// How thick the last slab is: what is nearer to the eye than the taps on both sides is no thicker than they are apart.
float crease_cosine_bitmask_thickness_of_last(crease_march march, float depth_after) {
    float thickness = march.last.thickness;
    if (crease_cosine_bitmask_isolated != 0) {
        bool isolated = march.last.depth + 0.1 * crease_radius < min(march.before_last, depth_after);
        thickness = isolated ? march.last.thin : thickness;
    }
    return thickness;
}

void crease_add(inout crease_march march, crease_contribution contribution) {
    if (march.taps > 0)
        crease_cosine_bitmask_hide_last(march,
                                        crease_cosine_bitmask_thickness_of_last(march, contribution.slab.depth));
    if (crease_most_layers > 1)
        crease_cosine_bitmask_hide(march, contribution.behind, contribution.behind_nearness);
    march.before_last = march.last.depth;
    march.last = contribution.slab;
    ++march.taps;
}

void crease_add_behind(inout crease_march march, crease_contribution front, crease_contribution behind) {
    crease_cosine_bitmask_hide(march, behind.own, behind.own_nearness);
    crease_cosine_bitmask_hide(march, behind.behind, behind.behind_nearness);
}

crease_march crease_cosine_bitmask_ended(crease_march march) {
    crease_cosine_bitmask_hide_last(march, crease_cosine_bitmask_thickness_of_last(march, crease_background));
    return march;
}

void crease_end_direction(inout crease_estimate estimate, crease_march march) {
    march = crease_cosine_bitmask_ended(march);
    float hidden = crease_cosine_bitmask_linear != 0 ? march.occlusion : float(crease_bit_count(march.hidden));
    estimate.hidden += march.weight * hidden;
    estimate.whole += march.weight;
}

float crease_estimate_occlusion(crease_estimate estimate) {
    return estimate.hidden / (max(estimate.whole, 1e-6) * float(crease_cosine_bitmask_sectors));
}

// What the hidden sectors take of the mean direction, an eighth of the angles from the eye down to the tangent plane at
// a time. One and a half times the mean of all half slices is the normal.
crease_open crease_open_direction(crease_march march, crease_receiver receiver, vec2 direction) {
    uint hidden = crease_cosine_bitmask_ended(march).hidden;
    float eye = atan(march.towards.y, march.towards.x), width = (1.57079633 + eye) / 8.0;
    uint below = (1u << uint(crease_cosine_bitmask_sectors)) - 1u; // the sectors on from an angle
    vec2 moved = vec2(0.0); // along the direction, and to the eye
    float turned = 0.0;
    for (int i = 0; i < 8; ++i) {
        float angle = width * (float(i) + 0.5); // from the eye
        uint above = below;
        below = (1u << uint(crease_cosine_bitmask_sector(march, sin(width * float(i + 1) - eye)))) - 1u;
        uint within = above & ~below;
        float taken = float(crease_bit_count(hidden & within));
        moved -= vec2(sin(angle), cos(angle)) * (1.5 / float(crease_cosine_bitmask_sectors) * taken);
        turned += width * taken / max(float(crease_bit_count(within)), 1.0);
    }
    return crease_open(vec3(direction * moved.x, moved.y) * march.weight, march.weight, turned * march.weight);
}
#ifdef __cplusplus
")glsl"
#endif
