// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// The mean height of what an area holds, over the plane through the receiver: statistical-volumetric-obscurance,
// equations 4.5 and 4.6 along the normal, 4.3 along the view, and the falloff of A.2. An area of less than 2 x 2 texels
// tells less, and one that holds the receiver alone nothing.
struct crease_estimate {
    float occlusion; // summed over the texels
    float texels;
};

struct crease_march {
    float occlusion;
    float texels;
    vec3 axis;  // view space, unit: along which heights are measured
    vec3 scale; // of a height to shares of the box, of the box's top and of the falloff
};

struct crease_contribution {
    float occlusion;
    float texels;
};

crease_estimate crease_estimate_begin(crease_receiver receiver) { return crease_estimate(0.0, 0.0); }

crease_march crease_begin_direction(crease_estimate estimate, crease_receiver receiver, vec2 direction) {
    vec3 axis = crease_mean_height_oriented != 0 ? receiver.normal : vec3(0.0, 0.0, 1.0);
    float radius = max(crease_radius, 1e-20);
    return crease_march(0.0, 0.0, axis,
                        1.0 / vec3(radius, crease_mean_height_threshold, max(crease_mean_height_falloff, 1e-6)));
}

crease_contribution crease_weigh(crease_march march, crease_receiver receiver, crease_tap tap, crease_layer layer) {
    float height = dot(layer.position - receiver.position, march.axis) * march.scale.x; // in radii
    float share = clamp((height - crease_mean_height_bias) * march.scale.y, 0.0, 1.0);
    float beyond = clamp((height - crease_mean_height_threshold) * march.scale.z, 0.0, 1.0);
    return crease_contribution(tap.inside ? layer.texels * (share * (1.0 - beyond)) : 0.0,
                               tap.inside ? layer.texels : 0.0);
}

void crease_add(inout crease_march march, crease_contribution contribution) {
    march.occlusion += contribution.occlusion;
    march.texels += contribution.texels;
}

void crease_end_direction(inout crease_estimate estimate, crease_march march) {
    estimate.occlusion += march.occlusion;
    estimate.texels += march.texels;
}

float crease_estimate_occlusion(crease_estimate estimate) {
    return estimate.occlusion / max(estimate.texels, 1.0) * clamp((estimate.texels - 1.0) / 3.0, 0.0, 1.0);
}

// Means over areas are of positions, less the mean depth of the picture, so that sums stay small; background is in
// none.
float crease_area_depth(float depth) { return depth > 0.0 && depth < crease_background ? depth : 0.0; }

vec3 crease_area_value(vec3 position, float centre) { return vec3(position.z + centre, position.xy); }

vec3 crease_area_position(vec3 value, float centre) { return vec3(value.yz, value.x - centre); }
#ifdef __cplusplus
")glsl"
#endif
