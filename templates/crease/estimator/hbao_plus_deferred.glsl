#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// Layers behind the front one count by how much more they occlude.

void crease_estimate_resume(inout crease_estimate estimate, crease_estimate there) {}

crease_contribution crease_estimate_least(crease_estimate estimate, crease_contribution front) { return front; }

void crease_estimate_raise(inout crease_estimate estimate, crease_contribution front, crease_contribution most) {
    estimate.occlusion += most.occlusion - front.occlusion;
}
#ifdef __cplusplus
")glsl"
#endif
