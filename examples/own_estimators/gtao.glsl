// SPDX-License-Identifier: MIT
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// Ground-truth ambient occlusion: Jimenez et al. 2016. Angles in a slice count from the way to the eye. Of a side of it,
// along which a direction marches, the paper integrates, with the horizon h and the projected normal's length L and angle n,
//     L (cos n - cos(2 h - n) + 2 h sin n) / 4 = (a sin^2 h + b (h - sin h cos h)) / 2,
// where a = L cos n and b = L sin n are the normal along the way to the eye and along the side. Each side is integrated by
// itself, so directions need no opposites; occlusion is the share that horizons hide of what is over the tangent plane.
struct crease_estimate {
    float hidden;  // summed over the directions: of each what its horizon hides
    float whole;   // and what is over its tangent plane
    float n_dot_v; // a
    vec2 on_disk;  // the normal along the axes of the disk
};

// A direction.
struct crease_march {
    float rise;    // of the horizon over the tangent plane: the difference of their cosines to the way to the eye
    vec2 normal;   // a and b
    float tangent; // the cosine between the tangent plane and the way to the eye
};

struct crease_contribution {
    float occlusion; // the rise
};

float crease_gtao_tangent(vec2 normal) {
    return clamp(-normal.y * inversesqrt(max(dot(normal, normal), 1e-12)), -1.0, 1.0); // in spite of rounding
}

// The integral up to the angle of this cosine.
float crease_gtao_open(vec2 normal, float cosine) {
    float sine = sqrt(1.0 - cosine * cosine);
    return 0.5 * (normal.x * sine * sine + normal.y * (acos(cosine) - sine * cosine));
}

crease_estimate crease_estimate_begin(crease_receiver receiver) {
    vec2 on_disk = vec2(dot(receiver.normal, receiver.tangent), dot(receiver.normal, receiver.bitangent));
    return crease_estimate(0.0, 0.0, max(dot(receiver.normal, receiver.to_eye), 0.0), on_disk);
}

crease_march crease_begin_direction(crease_estimate estimate, crease_receiver receiver, vec2 direction) {
    vec2 normal = vec2(estimate.n_dot_v, dot(estimate.on_disk, direction));
    return crease_march(0.0, normal, crease_gtao_tangent(normal));
}

// Of a layer in the half slice in which it lies, which its texel moves off the marched direction: so a plane is unoccluded
// at every slant.
float crease_gtao_rise(crease_march march, crease_receiver receiver, vec3 to_layer) {
    float squared = dot(to_layer, to_layer), towards = dot(to_layer, receiver.to_eye);
    float across = sqrt(max(squared - towards * towards, 1e-12 * squared));
    float along = (dot(to_layer, receiver.normal) - march.normal.x * towards) / across;
    return towards * inversesqrt(squared) - crease_gtao_tangent(vec2(march.normal.x, along));
}

// A layer far away lowers its horizon to the tangent plane.
crease_contribution crease_weigh(crease_march march, crease_receiver receiver, crease_tap tap, crease_layer layer) {
    vec3 to_layer = layer.position - receiver.position;
    float radii = length(to_layer) / max(crease_radius, 1e-20);
    float nearness = clamp((1.0 - radii) / max(crease_gtao_falloff, 1e-6), 0.0, 1.0);
    return crease_contribution(tap.inside ? nearness * crease_gtao_rise(march, receiver, to_layer) : 0.0);
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

float crease_gtao_horizon(crease_march march) { return min(march.tangent + march.rise, 1.0); }

void crease_end_direction(inout crease_estimate estimate, crease_march march) {
    float whole = crease_gtao_open(march.normal, march.tangent);
    estimate.hidden += whole - crease_gtao_open(march.normal, crease_gtao_horizon(march));
    estimate.whole += whole;
}

// Three times the integral of the directions themselves: of the direction, and of the way to the eye. Over all half slices
// down to their tangents its mean is the normal.
vec2 crease_gtao_mean(vec2 normal, float cosine) {
    float cubed = cosine * cosine * cosine, sine = sqrt(1.0 - cosine * cosine);
    float sine_cubed = sine * sine * sine;
    return vec2(normal.x * sine_cubed + normal.y * (2.0 - 3.0 * cosine + cubed),
                normal.x * (1.0 - cubed) + normal.y * sine_cubed);
}

// What the horizon takes of it, and the angle by which it rises.
crease_open crease_open_direction(crease_march march, crease_receiver receiver, vec2 direction) {
    float horizon = crease_gtao_horizon(march);
    vec2 moved = crease_gtao_mean(march.normal, horizon) - crease_gtao_mean(march.normal, march.tangent);
    return crease_open(vec3(direction * moved.x, moved.y), 1.0, acos(march.tangent) - acos(horizon));
}

float crease_estimate_occlusion(crease_estimate estimate) { return estimate.hidden / max(estimate.whole, 1e-6); }
#ifdef __cplusplus
")glsl"
#endif
