#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// Visibility, and the cone of open directions: stochastic-depth-ao 7.1.

float crease_visibility_of(float occlusion);
void crease_bend_tap(inout crease_bend bend, crease_receiver receiver, crease_tap tap,
                     crease_contribution contribution);
void crease_bend_turn(inout crease_bend bend, crease_receiver receiver, crease_estimate estimate, vec2 direction);
vec3 crease_bend_direction(crease_bend bend, crease_receiver receiver);
float crease_bend_cone(crease_bend bend);

struct crease_gathered {
    float occlusion;
    crease_bend bend;
    vec3 bent; // view space: the mean open direction, of any length
};

crease_gathered crease_gathered_begin() {
    return crease_gathered(0.0, crease_bend(vec3(0.0), 0.0, 0.0, 0.0), vec3(0.0));
}

void crease_gathered_tap(inout crease_gathered gathered, crease_receiver receiver, crease_tap tap,
                         crease_contribution contribution) {
    crease_bend_tap(gathered.bend, receiver, tap, contribution);
}

void crease_gathered_turn(inout crease_gathered gathered, crease_receiver receiver, crease_estimate estimate,
                          vec2 direction) {
    crease_bend_turn(gathered.bend, receiver, estimate, direction);
}

void crease_gathered_end(inout crease_gathered gathered, crease_receiver receiver) {
    gathered.bent = crease_bend_direction(gathered.bend, receiver);
}

// What was gathered in a camera's space, in that which `turn` leads from.
crease_gathered crease_gathered_turned_back(crease_gathered gathered, mat3 turn) {
    gathered.bent = gathered.bent * turn;
    return gathered;
}

crease_result crease_conclude(crease_gathered gathered, crease_receiver receiver) {
    return crease_result(crease_visibility_of(gathered.occlusion), -receiver.position.z, gathered.bent,
                         crease_bend_cone(gathered.bend));
}
#ifdef __cplusplus
")glsl"
#endif
