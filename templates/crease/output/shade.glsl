#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// The shade of a receiver beside its visibility: unsharp-mask-ssao's listing. Without highlights it is never negative.

crease_result crease_shade_result(float shade, float depth);

struct crease_gathered {
    float occlusion;
};

crease_gathered crease_gathered_begin() { return crease_gathered(0.0); }

void crease_gathered_tap(inout crease_gathered gathered, crease_receiver receiver, crease_tap tap,
                         crease_contribution contribution) {}

void crease_gathered_turn(inout crease_gathered gathered, crease_receiver receiver, crease_estimate estimate,
                          vec2 direction) {}

crease_gathered crease_gathered_turned_back(crease_gathered gathered, mat3 turn) { return gathered; }

crease_result crease_conclude(crease_gathered gathered, crease_receiver receiver) {
    float shade = crease_strength * gathered.occlusion;
    return crease_shade_result(crease_shade_highlight != 0 ? shade : max(shade, 0.0), -receiver.position.z);
}
#ifdef __cplusplus
")glsl"
#endif
