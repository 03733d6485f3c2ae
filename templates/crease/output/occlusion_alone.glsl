#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// Of what is gathered the occlusion, and nothing else.

struct crease_gathered {
    float occlusion;
};

crease_gathered crease_gathered_begin() { return crease_gathered(0.0); }

void crease_gathered_tap(inout crease_gathered gathered, crease_receiver receiver, crease_tap tap,
                         crease_contribution contribution) {}

void crease_gathered_turn(inout crease_gathered gathered, crease_receiver receiver, crease_estimate estimate,
                          vec2 direction) {}

void crease_gathered_end(inout crease_gathered gathered, crease_receiver receiver) {}

crease_gathered crease_gathered_turned_back(crease_gathered gathered, mat3 turn) { return gathered; }
#ifdef __cplusplus
")glsl"
#endif
