// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
vec3 crease_view_position(vec2 texel, float depth);
float crease_slice_weight(float share);
#else
__LINE__, R"glsl("
#endif

// A bitmask of the cosine lobe: Therrien et al. 2023, with sectors of equal cosine-weighted measure. Angles in a half slice
// count from the normal projected into it, towards the direction; the one of the eye is -g, that of the tangent plane a right
// angle. The measure from the eye to the angle of sine s is, with the normal's parts a along the eye and b along the
// direction,
//     (a s^2 + b B(s) + const) / 2, where B(s) = asin s + s cos(asin s), about s (2 - (2 - pi/2) s^2).
const int crease_cosine_bitmask_sectors = 31;
const float crease_cosine_bitmask_cubic = 0.42920367; // 2 - pi/2

// What is between the layer of a tap and another behind it. Heights over the tangent plane and distances along it are times
// cos g.
struct crease_cosine_bitmask_slab {
    float height, along;         // of the layer
    float ray_height, ray_along; // of the way on from it by a depth of 1
    float depth;                 // of the layer
    float gap, spacing;          // of the taps, as a share of the distance, and in radii
};

struct crease_estimate {
    float hidden; // summed over the directions, by their weights
    float whole;  // sum of the weights
};

// A direction.
struct crease_march {
    vec3 height, along; // the rows
    float bias;         // of the height
    float reach;        // 1 / (radius cos g)
    vec2 constant, linear, square, cubic; // of the sector at the sine of an angle, counted from the tangent plane
    float weight;
    vec2 towards;       // sine and cosine of g
    uint hidden;        // a bit for each sector
    float occlusion;    // of the hidden sectors by their nearness
    crease_cosine_bitmask_slab last;
    float before;       // depth of the tap before it
    int taps;
};

struct crease_contribution {
    crease_cosine_bitmask_slab slab; // the nearest of the tap
    uint own, behind;                // sectors that it hides, and that those behind it hide: where a tap has several
    float own_nearness, behind_nearness;
};

crease_estimate crease_estimate_begin(crease_receiver receiver) { return crease_estimate(0.0, 0.0); }

crease_march crease_begin_direction(crease_estimate estimate, crease_receiver receiver, vec2 direction) {
    vec3 azimuth = receiver.tangent * direction.x + receiver.bitangent * direction.y;
    vec2 normal = vec2(max(dot(receiver.normal, receiver.to_eye), 0.0), dot(receiver.normal, azimuth));
    float inverse = inversesqrt(max(dot(normal, normal), 1e-12));
    vec2 towards = normal * inverse; // cosine and sine of g
    // The approximation is less than 0 where the normal leans far away.
    float whole = max(normal.x * towards.x * towards.x +
                          normal.y * (1.57079633 + towards.y * (2.0 - crease_cosine_bitmask_cubic * towards.y * towards.y)),
                      0.02);
    vec2 k = normal * (float(crease_cosine_bitmask_sectors) / whole);
    crease_march march;
    march.height = receiver.normal * (towards.x * inverse);
    march.along = azimuth - receiver.normal * (towards.y * inverse);
    march.bias = -1e-5 * receiver.position.z;
    march.reach = 1.0 / (max(crease_radius, 1e-20) * max(towards.x, 1e-6));
    march.constant = vec2(k.x + k.y * 1.57079633 + 0.5);
    march.linear = vec2(-2.0 * k.y);
    march.square = vec2(-k.x);
    march.cubic = vec2(crease_cosine_bitmask_cubic * k.y);
    march.weight = crease_slice_weight(whole);
    march.towards = towards;
    march.hidden = 0u;
    march.occlusion = 0.0;
    march.last = crease_cosine_bitmask_slab(-1.0, 0.0, 0.0, 0.0, -receiver.position.z, 0.0, 0.0);
    march.before = 0.0;
    march.taps = 0;
    return march;
}

float crease_cosine_bitmask_sector(crease_march march, float sine) {
    return clamp(march.constant.x + sine * (march.linear.x + sine * (march.square.x + sine * march.cubic.x)), 0.0, 31.0);
}

// The sectors of a slab of this thickness, and 1 / the distance of its nearer end, times cos g.
uint crease_cosine_bitmask_sectors_of(crease_march march, crease_cosine_bitmask_slab slab, float thickness,
                                      out float nearest) {
    vec2 height = vec2(slab.height, slab.ray_height * thickness + slab.height);
    vec2 along = vec2(slab.along * max(1.0 - 0.3 * slab.gap, 0.4), slab.ray_along * thickness + slab.along);
    vec2 inverse = inversesqrt(height * height + along * along);
    nearest = max(inverse.x, inverse.y);
    vec2 sine = along * inverse;
    vec2 sector = march.constant + sine * (march.linear + sine * (march.square + sine * march.cubic));
    sector = mix(vec2(0.0), clamp(sector, 0.0, 31.0), greaterThan(height, vec2(0.0)));
    uvec2 bit = uvec2(1u) << uvec2(sector);
    uint hidden = bit.x - min(bit.x, bit.y);
    return nearest > march.reach ? hidden : 0u;
}

void crease_cosine_bitmask_hide(inout crease_march march, uint hidden, float nearness) {
    if (crease_cosine_bitmask_linear != 0)
        march.occlusion += float(bitCount(hidden & ~march.hidden)) * nearness;
    march.hidden |= hidden;
}

void crease_cosine_bitmask_hide_slab(inout crease_march march, crease_cosine_bitmask_slab slab, float thickness) {
    float nearest;
    uint hidden = crease_cosine_bitmask_sectors_of(march, slab, thickness, nearest);
    crease_cosine_bitmask_hide(march, hidden, 1.0 - march.reach / nearest);
}

crease_contribution crease_weigh(crease_march march, crease_receiver receiver, crease_tap tap, crease_layer layer) {
    vec3 eye = crease_view_position(tap.texel, 0.0), ray = crease_view_position(tap.texel, 1.0) - eye;
    vec3 start = eye - receiver.position;
    float depth = -layer.position.z;
    float ray_height = dot(march.height, ray), ray_along = dot(march.along, ray);
    float height = ray_height * depth + (dot(march.height, start) - march.bias);
    float along = ray_along * depth + dot(march.along, start);
    crease_contribution own;
    own.slab = crease_cosine_bitmask_slab(tap.inside ? height : -1.0, along, ray_height, ray_along, depth, tap.gap,
                                          tap.gap * tap.distance);
    own.own = 0u;
    own.behind = 0u;
    own.own_nearness = 0.0;
    own.behind_nearness = 0.0;
    if (crease_most_layers > 1) {
        float nearest;
        own.own = crease_cosine_bitmask_sectors_of(march, own.slab, crease_cosine_bitmask_thickness * crease_radius, nearest);
        own.own_nearness = 1.0 - march.reach / nearest;
    }
    return own;
}

// Layers of a tap hide what any of them hides.
crease_contribution crease_combine(crease_contribution a, crease_contribution b) {
    crease_contribution near = a, far = b;
    if (b.slab.depth < a.slab.depth) {
        near = b;
        far = a;
    }
    uint behind = (far.own | far.behind) & ~near.behind;
    float before = float(bitCount(near.behind)), added = float(bitCount(behind));
    near.behind_nearness = (before * near.behind_nearness + added * max(far.own_nearness, far.behind_nearness)) /
        max(before + added, 1.0);
    near.behind |= behind;
    return near;
}

// The way on from a layer leads down to the tangent plane.
bool crease_skip_behind(crease_march march, crease_receiver receiver, crease_tap tap, crease_layer front) {
    vec3 to_front = front.position - receiver.position;
    float height = dot(march.height, to_front) - march.bias;
    float along = dot(march.along, to_front) * max(1.0 - 0.3 * tap.gap, 0.4);
    float sector = crease_cosine_bitmask_sector(march, along * inversesqrt(height * height + along * along));
    uint below = height > 0.0 ? (1u << uint(sector)) - 1u : 0u;
    return (below & ~march.hidden) == 0u;
}

// What is nearer than the taps on both sides of it is no thicker than they are apart.
float crease_cosine_bitmask_thickness_of(crease_march march, float depth_after) {
    float thickness = crease_cosine_bitmask_thickness;
    if (crease_cosine_bitmask_isolated != 0) {
        bool isolated = march.last.depth + 0.1 * crease_radius < min(march.before, depth_after);
        float thin = min(thickness, 0.03 + march.last.spacing);
        thickness = isolated ? thin : thickness;
    }
    return thickness * crease_radius;
}

// A slab waits for the tap after it, which tells whether it is isolated.
void crease_add(inout crease_march march, crease_contribution contribution) {
    if (march.taps > 0)
        crease_cosine_bitmask_hide_slab(march, march.last,
                                        crease_cosine_bitmask_thickness_of(march, contribution.slab.depth));
    if (crease_most_layers > 1)
        crease_cosine_bitmask_hide(march, contribution.behind, contribution.behind_nearness);
    march.before = march.last.depth;
    march.last = contribution.slab;
    ++march.taps;
}

void crease_add_behind(inout crease_march march, crease_contribution front, crease_contribution behind) {
    crease_cosine_bitmask_hide(march, behind.own, behind.own_nearness);
    crease_cosine_bitmask_hide(march, behind.behind, behind.behind_nearness);
}

crease_march crease_cosine_bitmask_ended(crease_march march) {
    float thickness = crease_cosine_bitmask_thickness_of(march, crease_background);
    crease_cosine_bitmask_hide_slab(march, march.last, thickness);
    return march;
}

void crease_end_direction(inout crease_estimate estimate, crease_march march) {
    march = crease_cosine_bitmask_ended(march);
    float hidden = crease_cosine_bitmask_linear != 0 ? march.occlusion : float(bitCount(march.hidden));
    estimate.hidden += march.weight * hidden;
    estimate.whole += march.weight;
}

float crease_estimate_occlusion(crease_estimate estimate) {
    return estimate.hidden / (max(estimate.whole, 1e-6) * float(crease_cosine_bitmask_sectors));
}

// What the hidden sectors take of the mean direction, an eighth of the angles from the eye to the tangent plane at a time.
// One and a half times the mean of all half slices is the normal.
crease_open crease_open_direction(crease_march march, crease_receiver receiver, vec2 direction) {
    uint hidden = crease_cosine_bitmask_ended(march).hidden;
    float eye = atan(march.towards.y, march.towards.x), width = (1.57079633 + eye) / 8.0;
    uint below = (1u << uint(crease_cosine_bitmask_sectors)) - 1u; // sectors from an angle to the tangent plane
    vec2 moved = vec2(0.0); // along the direction, and to the eye
    float turned = 0.0;
    for (int i = 0; i < 8; ++i) {
        float angle = width * (float(i) + 0.5); // from the eye
        uint above = below;
        below = (1u << uint(crease_cosine_bitmask_sector(march, sin(width * float(i + 1) - eye)))) - 1u;
        uint within = above & ~below;
        float taken = float(bitCount(hidden & within));
        moved -= vec2(sin(angle), cos(angle)) * (1.5 / float(crease_cosine_bitmask_sectors) * taken);
        turned += width * taken / max(float(bitCount(within)), 1.0);
    }
    return crease_open(vec3(direction * moved.x, moved.y) * march.weight, march.weight, turned * march.weight);
}
#ifdef __cplusplus
")glsl"
#endif
