#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// The front surface of a tap, and whether the layers behind it may matter: stochastic-depth-ao 6.3.

float crease_depth_at(vec2 texel);
bool crease_front_settles(crease_estimate estimate, crease_receiver receiver, crease_tap tap, vec3 position);

// The front one; those behind it are fetched where they are asked for.
struct crease_layers {
    float front;
};

crease_layers crease_fetch_layers(vec2 texel) { return crease_layers(crease_depth_at(texel)); }

float crease_front_of(crease_layers layers) { return layers.front; }

// Whether layers behind a front surface may matter; `by_angle`: not where the estimator's test settles the tap.
bool crease_look_behind(crease_estimate estimate, crease_receiver receiver, crease_tap tap, vec3 front, bool by_angle) {
    vec3 to_front = front - receiver.position;
    float reach = crease_front_reach * crease_radius;
    return !(dot(to_front, to_front) < reach * reach) &&
        !(by_angle && crease_front_settles(estimate, receiver, tap, front));
}
#ifdef __cplusplus
")glsl"
#endif
