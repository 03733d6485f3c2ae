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

// The slab of a tap: what is between its layer and another that far behind it. The rows of a direction give of a point the
// height over the tangent plane and the distance along it, both times cos g.
struct crease_cosine_bitmask_slab {
    vec2 front;      // of the rows
    vec2 ray;        // of the rows, for a depth of 1 behind it
    float nearer;    // factor of the distance along the plane, of the edge that the spacing of the taps hides
    float spacing;   // of the taps, radii
    float depth;     // of the front
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
    vec4 sectors;       // coefficients of the sector at the sine of an angle, counted from the tangent plane
    float weight;
    vec2 towards;       // sine and cosine of g
    uint hidden;        // a bit for each sector
    float occlusion;    // of the hidden sectors by their nearness
    crease_cosine_bitmask_slab last;
    float before;       // depth of the tap before it
};

struct crease_contribution {
    crease_cosine_bitmask_slab slab; // the nearest of the tap
    uint hidden;                     // by those behind it
    float nearness;                  // of what they hide
};

float crease_cosine_bitmask_sector(vec4 sectors, float sine) {
    return sectors.x + sine * (sectors.y + sine * (sectors.z + sine * sectors.w));
}

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
    vec3 height = receiver.normal * (towards.x * inverse);
    vec3 along = azimuth - receiver.normal * (towards.y * inverse);
    crease_march march;
    march.height = height;
    march.along = along;
    march.bias = -1e-5 * receiver.position.z;
    march.reach = 1.0 / (max(crease_radius, 1e-20) * max(towards.x, 1e-6));
    march.sectors = vec4(k.x + k.y * 1.57079633 + 0.5, -2.0 * k.y, -k.x, crease_cosine_bitmask_cubic * k.y);
    march.weight = crease_slice_weight(whole);
    march.towards = towards;
    march.hidden = 0u;
    march.occlusion = 0.0;
    march.last = crease_cosine_bitmask_slab(vec2(-1.0, 0.0), vec2(0.0), 1.0, 1.0, -receiver.position.z);
    march.before = 0.0;
    return march;
}

// The sectors of a slab of this thickness, and 1 / the distance of its nearer end, times cos g.
uint crease_cosine_bitmask_hidden(crease_march march, crease_cosine_bitmask_slab slab, float thickness, out float nearest) {
    vec2 front = vec2(slab.front.x, slab.front.y * slab.nearer), back = slab.front + slab.ray * thickness;
    float front_inverse = inversesqrt(dot(front, front)), back_inverse = inversesqrt(dot(back, back));
    nearest = max(front_inverse, back_inverse);
    float front_sector = crease_cosine_bitmask_sector(march.sectors, front.y * front_inverse);
    float back_sector = crease_cosine_bitmask_sector(march.sectors, back.y * back_inverse);
    // Selects, as what is after && would be a branch.
    front_sector = front.x > 0.0 ? front_sector : 0.0;
    front_sector = nearest > march.reach ? front_sector : 0.0;
    back_sector = back.x > 0.0 ? back_sector : 0.0;
    int upper = int(clamp(front_sector, 0.0, 31.0));
    int lower = int(clamp(back_sector, 0.0, float(upper)));
    return (1u << uint(upper)) - (1u << uint(lower));
}

void crease_cosine_bitmask_hide(inout crease_march march, uint hidden, float nearness) {
    if (crease_cosine_bitmask_linear != 0)
        march.occlusion += float(bitCount(hidden & ~march.hidden)) * nearness;
    march.hidden |= hidden;
}

void crease_cosine_bitmask_hide_slab(inout crease_march march, crease_cosine_bitmask_slab slab, float thickness) {
    float nearest;
    uint hidden = crease_cosine_bitmask_hidden(march, slab, thickness, nearest);
    crease_cosine_bitmask_hide(march, hidden, 1.0 - march.reach / nearest);
}

crease_contribution crease_weigh(crease_march march, crease_receiver receiver, crease_tap tap, crease_layer layer) {
    vec3 to_layer = layer.position - receiver.position;
    vec3 ray = crease_view_position(tap.texel, 1.0) - crease_view_position(tap.texel, 0.0);
    vec2 front = vec2(dot(march.height, to_layer) - march.bias, dot(march.along, to_layer));
    front = tap.inside ? front : vec2(-1.0, 0.0);
    float nearer = max(0.4, 1.0 - 0.3 * tap.spacing / tap.distance);
    return crease_contribution(
        crease_cosine_bitmask_slab(front, vec2(dot(march.height, ray), dot(march.along, ray)), nearer, tap.spacing,
                                   -layer.position.z),
        0u, 0.0);
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

void crease_add(inout crease_march march, crease_contribution contribution) {
    crease_cosine_bitmask_hide_slab(march, march.last, crease_cosine_bitmask_thickness_of(march, contribution.slab.depth));
    crease_cosine_bitmask_hide(march, contribution.hidden, contribution.nearness);
    march.before = march.last.depth;
    march.last = contribution.slab;
}

void crease_end_direction(inout crease_estimate estimate, crease_march march) {
    crease_cosine_bitmask_hide_slab(march, march.last, crease_cosine_bitmask_thickness_of(march, crease_background));
    float hidden = crease_cosine_bitmask_linear != 0 ? march.occlusion : float(bitCount(march.hidden));
    estimate.hidden += march.weight * hidden;
    estimate.whole += march.weight;
}

float crease_estimate_occlusion(crease_estimate estimate) {
    return estimate.hidden / (max(estimate.whole, 1e-6) * float(crease_cosine_bitmask_sectors));
}
#ifdef __cplusplus
")glsl"
#endif
