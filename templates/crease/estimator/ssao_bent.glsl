#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// The mean direction of the points, weighed by how open they are, and the cone that its length stands for:
// stochastic-depth-ao 7.1, Algorithm 10. A point beside the picture counts as open, as leaving it out would turn the cone
// to the picture's middle.

bool crease_ssao_over(crease_receiver receiver, crease_tap tap);

void crease_bend_tap(inout crease_bend bend, crease_receiver receiver, crease_tap tap,
                     crease_contribution contribution) {
    float known = tap.inside ? contribution.points : 1.0;
    float open = crease_ssao_over(receiver, tap) ? known - contribution.occlusion : 0.0;
    bend.sum += tap.offset * (open * inversesqrt(max(dot(tap.offset, tap.offset), 1e-30)));
    bend.weight += open;
}

void crease_bend_turn(inout crease_bend bend, crease_receiver receiver, crease_estimate estimate, vec2 direction) {}

// The normal where no point is open.
vec3 crease_bend_direction(crease_bend bend, crease_receiver receiver) {
    return bend.sum + receiver.normal * 1e-6;
}

float crease_bend_cone(crease_bend bend) {
    float mean_length = length(bend.sum) / max(bend.weight, 1e-6);
    return 1.57079633 * (1.0 - max(2.0 * mean_length - 1.0, 0.0));
}
#ifdef __cplusplus
")glsl"
#endif
