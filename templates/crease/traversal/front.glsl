// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
float crease_depth_at(vec2 texel);
vec3 crease_view_position(vec2 texel, float depth);
crease_layer crease_layer_of(vec3 position);
bool crease_skip_behind(crease_march march, crease_receiver receiver, crease_tap tap, crease_layer front);
#else
__LINE__, R"glsl("
#endif

// Fetches the front surface only; layers behind it are fetched on demand: stochastic-depth-ao 6.3.
struct crease_fetched {
    float front; // depth
};

crease_fetched crease_fetch(vec2 texel) { return crease_fetched(crease_depth_at(texel)); }

crease_layer crease_front_layer(crease_tap tap, crease_fetched fetched) {
    return crease_layer_of(crease_view_position(tap.texel, fetched.front));
}

// Whether layers behind the front one may add occlusion: not if it lies within `reach` radii, nor, `by_angle`, if the
// estimator skips them.
bool crease_behind_matters(crease_march march, crease_receiver receiver, crease_tap tap, crease_layer front, float reach,
                           bool by_angle) {
    vec3 to_front = front.position - receiver.position;
    float nearest = reach * crease_radius;
    return !(dot(to_front, to_front) < nearest * nearest) &&
        !(by_angle && crease_skip_behind(march, receiver, tap, front));
}

// Captured layers are kept if they lie behind the depth image's.
bool crease_keeps_layer(float depth, float front) { return depth > front + 1e-4 * front; }
#ifdef __cplusplus
")glsl"
#endif
