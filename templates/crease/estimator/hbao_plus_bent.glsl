#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// For each direction the normal, turned away from the highest tap by its angle over the tangent plane:
// stochastic-depth-ao 7.1, the form with lambda.

vec3 crease_bent_turn(crease_receiver receiver, vec2 direction, float cosine, float sine);
float crease_bent_angle(float cosine, float sine);

void crease_bend_tap(inout crease_bend bend, crease_receiver receiver, crease_tap tap,
                     crease_contribution contribution) {
    bend.highest = max(bend.highest, contribution.rise);
}

void crease_bend_turn(inout crease_bend bend, crease_receiver receiver, crease_estimate estimate, vec2 direction) {
    float sine = min(bend.highest, 1.0);
    float cosine = sqrt(1.0 - sine * sine);
    bend.sum += crease_bent_turn(receiver, direction, cosine, sine);
    bend.turned += crease_bent_angle(cosine, sine);
    bend.weight += 1.0;
    bend.highest = 0.0;
}
#ifdef __cplusplus
")glsl"
#endif
