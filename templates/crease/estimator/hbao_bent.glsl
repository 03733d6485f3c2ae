#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// For each direction the normal, turned away from the horizon by its angle over the tangent: stochastic-depth-ao 7.1,
// Algorithm 11.

vec3 crease_bent_turn(crease_receiver receiver, vec2 direction, float cosine, float sine);
float crease_bent_angle(float cosine, float sine);

void crease_bend_tap(inout crease_bend bend, crease_receiver receiver, crease_tap tap,
                     crease_contribution contribution) {}

void crease_bend_turn(inout crease_bend bend, crease_receiver receiver, crease_estimate estimate, vec2 direction) {
    vec2 start = vec2(estimate.cos_tangent * estimate.bias.x - estimate.sin_tangent * estimate.bias.y,
                      estimate.sin_tangent * estimate.bias.x + estimate.cos_tangent * estimate.bias.y);
    float sin_horizon = min(estimate.sin_tangent + estimate.rise, 1.0);
    float cos_horizon = sqrt(1.0 - sin_horizon * sin_horizon);
    // The horizon's angle less that at which the direction began.
    float cosine = cos_horizon * start.x + sin_horizon * start.y;
    float sine = max(sin_horizon * start.x - cos_horizon * start.y, 0.0);
    bend.sum += crease_bent_turn(receiver, direction, cosine, sine);
    bend.turned += crease_bent_angle(cosine, sine);
    bend.weight += 1.0;
}
#ifdef __cplusplus
")glsl"
#endif
