#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// The shade of a receiver beside its visibility: unsharp-mask-ssao's listing. Without highlights it is never negative.

crease_result crease_shade_result(float shade, float depth);

crease_result crease_conclude(crease_gathered gathered, crease_receiver receiver) {
    float shade = crease_strength * gathered.occlusion;
    return crease_shade_result(crease_shade_highlight != 0 ? shade : max(shade, 0.0), -receiver.position.z);
}
#ifdef __cplusplus
")glsl"
#endif
