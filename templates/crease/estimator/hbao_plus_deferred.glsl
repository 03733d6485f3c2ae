#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// Layers behind the front one count by how much more they occlude.

float crease_depth_at(vec2 texel);
vec3 crease_view_position(vec2 texel, float depth);
crease_contribution crease_weigh(crease_estimate estimate, crease_receiver receiver, crease_tap tap, vec3 position);

void crease_estimate_resume(inout crease_estimate estimate, crease_estimate there) {}

crease_contribution crease_front_again(crease_estimate estimate, crease_receiver receiver, crease_tap tap) {
    return crease_weigh(estimate, receiver, tap, crease_view_position(tap.texel, crease_depth_at(tap.texel)));
}

void crease_estimate_raise(inout crease_estimate estimate, crease_contribution front, crease_contribution most) {
    estimate.occlusion += most.occlusion - front.occlusion;
}
#ifdef __cplusplus
")glsl"
#endif
