#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// The mean height of what an area holds, over the plane through the receiver: statistical-volumetric-obscurance,
// equations 4.5 and 4.6 along the normal, 4.3 along the view, and the falloff of A.2. An area of less than 2 x 2 texels
// tells less, and one that holds the receiver alone nothing.

struct crease_estimate {
    float occlusion; // summed over the texels
    float texels;
    vec3 axis;       // view space, unit: along which heights are measured
    vec3 scale;      // of a height to shares of the box, of the box's top and of the falloff
};

struct crease_contribution {
    float occlusion;
    float texels;
};

crease_estimate crease_estimate_begin(crease_receiver receiver) {
    vec3 axis = crease_mean_height_oriented != 0 ? receiver.normal : vec3(0.0, 0.0, 1.0);
    float radius = max(crease_radius, 1e-20);
    return crease_estimate(0.0, 0.0, axis, 1.0 / vec3(radius, crease_threshold, max(crease_falloff, 1e-6)));
}

void crease_estimate_turn(inout crease_estimate estimate, vec2 direction) {}

crease_contribution crease_weigh(crease_estimate estimate, crease_receiver receiver, crease_tap tap, vec3 position) {
    float height = dot(position - receiver.position, estimate.axis) * estimate.scale.x; // in radii
    float share = clamp((height - crease_bias) * estimate.scale.y, 0.0, 1.0);
    float beyond = clamp((height - crease_threshold) * estimate.scale.z, 0.0, 1.0);
    return tap.inside ? crease_contribution(share * (1.0 - beyond), 1.0) : crease_contribution(0.0, 0.0);
}

void crease_estimate_add(inout crease_estimate estimate, crease_contribution contribution) {
    estimate.occlusion += contribution.occlusion;
    estimate.texels += contribution.texels;
}

float crease_estimate_occlusion(crease_estimate estimate) {
    return estimate.occlusion / max(estimate.texels, 1.0) * clamp((estimate.texels - 1.0) / 3.0, 0.0, 1.0);
}
#ifdef __cplusplus
")glsl"
#endif
