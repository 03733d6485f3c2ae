#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// Layers behind the front ones come after all front ones of their direction, and count from its horizon.

void crease_estimate_add(inout crease_estimate estimate, crease_contribution contribution);

void crease_estimate_resume(inout crease_estimate estimate, crease_estimate there) {
    estimate.rise = there.rise;
}

// What layers behind a front surface have to exceed: the horizon is as high as that surface.
crease_contribution crease_estimate_least(crease_estimate estimate, crease_contribution front) {
    return crease_contribution(0.0, estimate.rise);
}

void crease_estimate_raise(inout crease_estimate estimate, crease_contribution front, crease_contribution most) {
    crease_estimate_add(estimate, most);
}
#ifdef __cplusplus
")glsl"
#endif
